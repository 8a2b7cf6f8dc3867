//! What strings have in common is taken over from the one before, and nothing else is.

use linear::{
    AxialForce, Budget, ChannelRequest, Drillstring, Earlier, Hole, HoleSection, Method, Mud,
    Request, ResponsePlan, Responses, Sites, SurfaceSupport, TopDrive, responses,
};
use problems::academic::{self, BENDING};

fn request(string: &Drillstring) -> Request {
    Request {
        sites: Sites::new(string, &[0.0]).unwrap(),
        channels: vec![
            ChannelRequest::Torsion { torques: vec![0] },
            ChannelRequest::Bending {
                bending: BENDING,
                support: SurfaceSupport::Free,
            },
        ],
        sampling_frequency: 200.0,
        longest_time: 1.0,
    }
}

/// Responses that are known when they are met again, for nothing has them.
fn marked(mut responses: Responses) -> Responses {
    for channel in &mut responses.channels {
        let taps = channel.from_loads.iter_mut().flatten().flatten();
        taps.for_each(|tap| *tap *= 2.0);
    }
    responses
}

/// Whether each channel, torsion and bending, is taken over by another string, request and method.
fn taken_over(string: &Drillstring, asked: &Request, method: Method) -> [bool; 2] {
    let before = academic::string();
    let request = request(&before);
    let built = responses(&before, &Method::Quadrature, &request).unwrap();
    let after = |responses: &Responses| {
        let earlier = Earlier {
            string: &before,
            request: &request,
            responses,
        };
        let plan = ResponsePlan::after(string, &method, asked, earlier).unwrap();
        plan.build(&Budget::unlimited()).unwrap()
    };
    // Everything that is reused equals what would be built.
    let fresh = responses(string, &method, asked).unwrap();
    assert_eq!(after(&built), fresh);
    let (marked, fresh) = (after(&marked(built)).channels, fresh.channels);
    [0, 1].map(|channel| marked[channel] != fresh[channel])
}

#[test]
fn a_string_takes_over_the_channels_in_which_it_moves_as_before() {
    let of = |string: &Drillstring| taken_over(string, &request(string), Method::Quadrature);
    let string = academic::string;
    assert_eq!(of(&string()), [true, true]);
    assert_eq!(of(&academic::damped_string(11.0)), [false, true]);
    let drive = TopDrive {
        inertia: 2000.0,
        proportional_gain: 1000.0,
        integral_gain: 500.0,
        delay: 0.0,
        late_inertia: 0.0,
    };
    assert_eq!(of(&string().with_top_drive(drive).unwrap()), [false, true]);
    let pull = AxialForce {
        length: string().length(),
        tension: 1e5,
    };
    assert_eq!(
        of(&string().under_axial_force(vec![pull]).unwrap()),
        [true, false]
    );
    let hole = Hole {
        sections: vec![HoleSection {
            length: string().length(),
            radius: 0.2,
        }],
        mud: Mud {
            density: 1200.0,
            viscosity: 0.0,
        },
    };
    assert_eq!(of(&string().in_hole(hole).unwrap()), [true, false]);
    let mut sections = string().sections().to_vec();
    sections[0].repeat -= 1;
    let shorter = Drillstring::new(string().material(), sections, string().torsional_damping());
    assert_eq!(of(&shorter.unwrap()), [false, false]);
    let mut material = string().material();
    material.density += 1.0;
    let heavier = Drillstring::new(
        material,
        string().sections().to_vec(),
        string().torsional_damping(),
    );
    assert_eq!(of(&heavier.unwrap()), [false, false]);
}

#[test]
fn what_is_asked_for_otherwise_is_built() {
    let string = academic::string();
    let same = request(&string);
    let of = |asked: Request| taken_over(&string, &asked, Method::Quadrature);
    let [
        mut torques,
        mut bending,
        mut longer,
        mut finer,
        mut elsewhere,
    ] = std::array::from_fn(|_| same.clone());
    torques.channels[0] = ChannelRequest::Torsion { torques: vec![] };
    assert!(of(torques)[1]);
    bending.channels[1] = ChannelRequest::Bending {
        bending: BENDING,
        support: SurfaceSupport::Pinned,
    };
    assert_eq!(of(bending), [true, false]);
    longer.longest_time += 1.0;
    assert_eq!(of(longer), [false, false]);
    finer.sampling_frequency += 1.0;
    assert_eq!(of(finer), [false, false]);
    elsewhere.sites = Sites::new(&string, &[10.0]).unwrap();
    assert_eq!(of(elsewhere), [false, false]);
    let by_elements = Method::FiniteElement(Default::default());
    assert_eq!(taken_over(&string, &same, by_elements), [false, false]);
}
