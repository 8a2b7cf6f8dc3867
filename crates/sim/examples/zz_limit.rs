use linear::*;
use sim::excitation::least_impulse;
use sim::*;
fn tube(l: f64, i: f64, o: f64) -> Tube {
    Tube {
        length: l,
        inner_radius: i,
        outer_radius: o,
    }
}
fn main() {
    let steel = Material {
        shear_modulus: 80e9,
        density: 7840.0,
    };
    let s = |v: Vec<(usize, Vec<Tube>)>, c: f64| {
        Drillstring::new(
            steel,
            v.into_iter()
                .map(|(r, p)| Section {
                    repeat: r,
                    parts: p,
                })
                .collect(),
            c,
        )
        .unwrap()
    };
    let strings = vec![
        (
            "uniform",
            s(vec![(1, vec![tube(1000.0, 0.05, 0.15)])], 10.0),
        ),
        (
            "collar",
            s(
                vec![
                    (1, vec![tube(900.0, 0.05, 0.125)]),
                    (1, vec![tube(100.0, 0.05, 0.15)]),
                ],
                10.0,
            ),
        ),
        (
            "paper",
            s(
                vec![
                    (90, vec![tube(9.5, 0.05, 0.125), tube(0.5, 0.05, 0.15)]),
                    (10, vec![tube(10.0, 0.05, 0.15)]),
                ],
                10.0,
            ),
        ),
    ];
    let bit = BitTorque {
        torque_static: 4800.0,
        torque_dynamic: 4000.0,
    };
    for (n, st) in &strings {
        for m in [
            Method::Held,
            Method::Quadrature,
            Method::Hilbert(Default::default()),
        ] {
            print!("{n} {:10}", m.name());
            for f in [80.0, 160.0, 320.0, 640.0, 1280.0, 2560.0] {
                let r = Request {
                    sites: Sites::bit(),
                    channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
                    sampling_frequency: f,
                    longest_time: 400.0,
                };
                let x = responses(st, &m, &r).unwrap();
                let sim = Simulator::new(&x).unwrap();
                let (mut lo, mut hi) = (0.05f64, 1.0f64);
                for _ in 0..14 {
                    let c = (lo * hi).sqrt();
                    let sp = c * std::f64::consts::PI / 30.0;
                    let sc = Scene {
                        surface_speed: sp,
                        bit: Some(bit),
                        lateral: None,
                        timing: torsion_timing(st, sp, &bit),
                    };
                    let o = sim.simulate(&sc, Stopping::Early, None).unwrap();
                    if o.torsion.unwrap().regime == TorsionRegime::StickSlip {
                        lo = c
                    } else {
                        hi = c
                    }
                }
                print!(" {:.5}", (lo * hi).sqrt() / 4.0);
            }
            println!();
        }
    }
    let st = &strings[2].1;
    let bend = Bending {
        youngs_modulus: 210e9,
        damping: 2000.0,
        compression: 0.0,
    };
    for m in [Method::Held, Method::Quadrature] {
        for f in [80.0, 160.0, 320.0, 640.0] {
            let r = Request {
                sites: Sites::bit(),
                channels: vec![
                    ChannelRequest::Torsion { torques: vec![0] },
                    ChannelRequest::Bending {
                        bending: bend,
                        support: SurfaceSupport::Free,
                    },
                ],
                sampling_frequency: f,
                longest_time: 10.0,
            };
            let x = responses(st, &m, &r).unwrap();
            let sim = Simulator::new(&x).unwrap();
            let i0 = least_impulse(
                &x.bending().unwrap().from_loads[0][0],
                f,
                m.moment(),
                0.02,
                0.015,
            );
            for stiff in [1e9, f64::INFINITY] {
                let run = |mu: f64| {
                    let sc = Scene {
                        surface_speed: std::f64::consts::TAU,
                        bit: None,
                        lateral: Some(Lateral {
                            walls: vec![Wall {
                                clearance: 0.015,
                                stiffness: stiff,
                                friction: mu,
                                radius: 0.15,
                            }],
                            impulses: vec![Impulse {
                                site: 0,
                                amount: 3.0 * i0,
                                start: 1.0,
                                duration: 0.02,
                                direction: 0.0,
                            }],
                            eccentric_masses: vec![],
                        }),
                        timing: Timing {
                            duration: 10.0,
                            closing_window: 2.0,
                        },
                    };
                    sim.simulate(&sc, Stopping::Full, None)
                        .unwrap()
                        .lateral
                        .unwrap()
                };
                let (mut lo, mut hi) = (0.8f64, 3.0f64);
                for _ in 0..14 {
                    let c = 0.5 * (lo + hi);
                    if run(c).regime == sim::watch::lateral::LateralRegime::BackwardWhirl {
                        hi = c
                    } else {
                        lo = c
                    }
                }
                let w = run(2.0);
                println!(
                    "{:10} {f} k {stiff:e} i0 {i0:.2} limit {:.4}  whirl r {:.5e} rate {:.4} F {:.5e} roll {:.2}",
                    m.name(),
                    0.5 * (lo + hi),
                    w.mean_radius,
                    w.precession_rate,
                    w.mean_normal_force,
                    w.rolling_fraction
                );
            }
        }
    }
}
