use linear::*;
use sim::*;
fn main() {
    let steel = Material {
        shear_modulus: 80e9,
        density: 7840.0,
    };
    let st = Drillstring::new(
        steel,
        vec![Section {
            repeat: 1,
            parts: vec![Tube {
                length: 1000.0,
                inner_radius: 0.05,
                outer_radius: 0.15,
            }],
        }],
        10.0,
    )
    .unwrap();
    let bit = BitTorque {
        torque_static: 4800.0,
        torque_dynamic: 4000.0,
    };
    for m in [Method::Held] {
        for f in [
            160.0,
            640.0,
            (80e9f64 / 7840.0).sqrt() * 0.2,
            (80e9f64 / 7840.0).sqrt(),
            (80e9f64 / 7840.0).sqrt() * 4.0,
        ] {
            let r = Request {
                sites: Sites::bit(),
                channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
                sampling_frequency: f,
                longest_time: 4000.0,
            };
            let x = responses(&st, &m, &r).unwrap();
            let sim = Simulator::new(&x).unwrap();
            print!("{} {f} ", m.name());
            for i in 0..60 {
                let c = (0.050 + 0.0002 * i as f64) * 4.0;
                let sp = c * std::f64::consts::PI / 30.0;
                let sc = Scene {
                    surface_speed: sp,
                    bit: Some(bit),
                    lateral: None,
                    timing: Timing {
                        duration: std::env::args().nth(1).unwrap().parse::<f64>().unwrap()
                            * torsion_timing(&st, sp, &bit).duration,
                        closing_window: torsion_timing(&st, sp, &bit).closing_window,
                    },
                };
                let o = sim.simulate(&sc, Stopping::Early, None).unwrap();
                print!(
                    "{}",
                    if o.torsion.unwrap().regime == TorsionRegime::StickSlip {
                        '#'
                    } else {
                        '.'
                    }
                );
            }
            println!();
        }
    }
}
