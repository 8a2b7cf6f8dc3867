use linear::*;
use sim::*;
fn main() {
    let c = (80e9f64 / 7840.0).sqrt();
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
    for f in [c * 0.2, c * 0.2 * 1.0007, c * 0.8, c * 0.8 * 1.0007] {
        let r = Request {
            sites: Sites::bit(),
            channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
            sampling_frequency: f,
            longest_time: 400.0,
        };
        let x = responses(&st, &Method::Held, &r).unwrap();
        let sim = Simulator::new(&x).unwrap();
        let sp = 0.055 * 4.0 * std::f64::consts::PI / 30.0;
        let sc = Scene {
            surface_speed: sp,
            bit: Some(bit),
            lateral: None,
            timing: Timing {
                duration: 60.0,
                closing_window: 10.0,
            },
        };
        let mut t = Trajectory::default();
        let o = sim.simulate(&sc, Stopping::Full, Some(&mut t)).unwrap();
        println!(
            "f {f:.3} 2tau/dt {:.3} {:?}",
            2000.0 / c * f,
            o.torsion.unwrap()
        );
        let v = &t.speeds[0];
        let tq = &t.bit_torque;
        for (a, b) in [(8.0440, 8.0480), (8.670, 8.676), (9.290, 9.302)] {
            for i in 0..v.len() {
                if t.times[i] > a && t.times[i] < b && (f < 1000.0 || i % 4 == 0) {
                    print!(" [{:.4} {:.5} {:.0}]", t.times[i], v[i], tq[i]);
                }
            }
            println!();
        }
        let mut stuck = true;
        let mut out = String::new();
        for (i, &w) in v.iter().enumerate() {
            let s = w == 0.0;
            if s != stuck {
                out += &format!(" {}{:.4}", if s { "|" } else { ">" }, t.times[i]);
                stuck = s;
            }
        }
        println!("   {}", &out[..out.len().min(400)]);
    }
}
