//! Finite elements: the taps, found without a step, against Newmark's scheme stepped in time
//! over a sparse model of the whole string, in Clough and Wilson's form. The two share
//! nothing but the elements.

use linear::elements::newmark::Weights;
use linear::elements::reconstruction::WholeString;
use linear::elements::reduction::{CondensedBeam, CondensedString};
use linear::method::FiniteElement;
use linear::{
    AxialForce, Bending, Budget, ChannelRequest, ChannelResponses, Drillstring, Hole, HoleSection,
    Method, Mud, PlacePlan, PlaceQuantity, Request, Responses, Section, Sites, SteppedString,
    SurfaceSupport, TopDrive,
};
use problems::academic::{self, tube};
use proptest::prelude::*;

/// A string, how it is divided and stepped, and where it is observed.
#[derive(Debug, Clone)]
struct Model {
    string: Drillstring,
    parameters: FiniteElement,
    sampling_frequency: f64,
    sites: Sites,
    bending: Bending,
    support: SurfaceSupport,
}

/// Steps compared.
const STEPS: usize = 600;

/// The largest difference of two lists, as far as both go.
fn difference(a: &[f64], b: &[f64]) -> f64 {
    let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    differences.fold(0.0, f64::max)
}

/// The largest magnitude of a list's first steps.
fn peak(taps: &[f64]) -> f64 {
    let magnitudes = taps.iter().take(STEPS).map(|tap| tap.abs());
    magnitudes.fold(0.0, f64::max)
}

impl Model {
    fn weights(&self) -> Weights {
        Weights::new(&self.parameters, self.sampling_frequency).unwrap()
    }

    /// Taps for as many times [`STEPS`].
    fn taps(&self, channel: ChannelRequest, times: usize) -> ChannelResponses {
        let request = Request {
            sites: self.sites.clone(),
            channels: vec![channel],
            sampling_frequency: self.sampling_frequency,
            longest_time: (times * STEPS - 1) as f64 / self.sampling_frequency,
        };
        let method = Method::FiniteElement(self.parameters);
        let mut found = linear::responses(&self.string, &method, &request).unwrap();
        found.channels.remove(0)
    }

    /// The largest difference from steps in torsion, over the largest response of its kind:
    /// from the surface, and from a torque at each site.
    fn difference_in_torsion(&self) -> f64 {
        let count = self.sites.len();
        let torques = (0..count).collect();
        let found = self.taps(ChannelRequest::Torsion { torques }, 1);
        let elements = self.parameters.elements_per_cell;
        let stepped =
            CondensedString::new(&self.string, &self.sites, elements, self.weights()).unwrap();
        let run = |input: Option<usize>| {
            let mut state = stepped.rest();
            let mut speeds = vec![Vec::new(); count];
            for step in 0..STEPS {
                let unit = if step == 0 { 1.0 } else { 0.0 };
                stepped.step_free(&mut state, if input.is_none() { unit } else { 0.0 });
                if let Some(site) = input {
                    stepped.apply_torque(&mut state, site, unit);
                }
                for (site, speeds) in speeds.iter_mut().enumerate() {
                    speeds.push(stepped.speed(&state, site));
                }
            }
            speeds
        };
        let inputs = std::iter::once(None).chain((0..count).map(Some));
        let differences = inputs.map(|input| {
            let stepped = run(input);
            let largest = stepped
                .iter()
                .map(|speeds| peak(speeds))
                .fold(0.0, f64::max);
            let taps = |site: usize| match input {
                None => &found.from_surface[site],
                Some(load) => &found.from_loads[site][load],
            };
            let sites = stepped.iter().enumerate();
            let differences = sites.map(|(site, speeds)| difference(taps(site), speeds) / largest);
            differences.fold(0.0, f64::max)
        });
        differences.fold(0.0, f64::max)
    }

    /// The largest differences in bending, over the largest response: from steps, and from
    /// the same taps as part of a longer response, which are found at other ζ.
    fn differences_in_bending(&self) -> [f64; 2] {
        let count = self.sites.len();
        let channel = ChannelRequest::Bending {
            bending: self.bending,
            support: self.support,
        };
        let found = self.taps(channel.clone(), 1);
        let longer = self.taps(channel, 3);
        let stepped = CondensedBeam::new(
            &self.string,
            &self.bending,
            self.support,
            &self.sites,
            self.parameters.elements_per_cell,
            self.weights(),
        )
        .unwrap();
        let (mut from_steps, mut from_longer, mut largest) = (0.0f64, 0.0f64, 0.0f64);
        for load in 0..count {
            let mut motion = stepped.rest();
            let mut displacements = vec![Vec::new(); count];
            for step in 0..STEPS {
                stepped.step_free(&mut motion);
                if step == 0 {
                    stepped.apply_force(&mut motion, load, 1.0);
                }
                for (site, displacements) in displacements.iter_mut().enumerate() {
                    displacements.push(stepped.displacement(&motion, site));
                }
            }
            for (site, stepped) in displacements.iter().enumerate() {
                let found = &found.from_loads[site][load];
                largest = largest.max(peak(stepped));
                from_steps = from_steps.max(difference(found, stepped));
                from_longer = from_longer.max(difference(found, &longer.from_loads[site][load]));
            }
        }
        [from_steps / largest, from_longer / largest]
    }
}

fn any_model() -> impl Strategy<Value = Model> {
    let pipes = (1..60usize, 5.0..12.0f64, 0.3..0.7f64, 0.08..0.16f64);
    let collars = (5.0..80.0f64, 0.12..0.16f64);
    let elements = (1..30usize, prop::sample::select(vec![0.5, 0.52, 0.6]));
    // A site cuts a pipe; elements of millimetres would leave steps no digit.
    let observed = (50.0..2000.0f64, 0.0..1.0f64, 0.1..0.9f64);
    let pulled = prop::option::of((0.05..0.95f64, 0.0..1e5f64, 0.0..2e4f64));
    let bent = (100.0..5000.0f64, -1e5..0.0f64, 0..3usize, pulled);
    (pipes, collars, elements, observed, bent, 0.0..30.0f64).prop_map(
        |(pipes, collars, elements, observed, bent, torsional_damping)| {
            let (repeat, pipe, joint, radius) = pipes;
            let sections = vec![
                Section {
                    repeat,
                    parts: vec![tube(pipe, radius), tube(joint, 1.2 * radius)],
                },
                Section {
                    repeat: 1,
                    parts: vec![tube(collars.0, collars.1)],
                },
            ];
            let material = academic::string().material();
            let mut string = Drillstring::new(material, sections, torsional_damping).unwrap();
            let (sampling_frequency, place, cut) = observed;
            let above = (place * repeat as f64).floor() * (pipe + joint) + cut * pipe;
            let sites = Sites::new(&string, &[0.0, string.length() - above]).unwrap();
            let (damping, compression, support, pulled) = bent;
            if let Some((part, above, below)) = pulled {
                let piece = |part: f64, tension| AxialForce {
                    length: part * string.length(),
                    tension,
                };
                let force = vec![piece(part, above), piece(1.0 - part, below)];
                string = string.under_axial_force(force).unwrap();
            }
            Model {
                parameters: FiniteElement {
                    elements_per_cell: elements.0,
                    gamma: elements.1,
                    beta: None,
                },
                sampling_frequency,
                sites,
                bending: Bending {
                    damping,
                    compression,
                    ..academic::BENDING
                },
                support: [
                    SurfaceSupport::Free,
                    SurfaceSupport::Pinned,
                    SurfaceSupport::Clamped,
                ][support],
                string,
            }
        },
    )
}

/// The paper's string, with three sites.
#[test]
fn val_taps_of_the_papers_string_are_those_of_stepping_all_of_it() {
    let string = academic::string();
    let model = Model {
        sites: Sites::new(&string, &[0.0, 36.0, 250.0]).unwrap(),
        string,
        parameters: FiniteElement::default(),
        sampling_frequency: academic::SAMPLING_FREQUENCY,
        bending: academic::BENDING,
        support: SurfaceSupport::Free,
    };
    let torsion = model.difference_in_torsion();
    assert!(torsion < 1e-9, "{torsion}");
    let [bending, longer] = model.differences_in_bending();
    assert!(bending < 1e-9 && longer < 1e-9, "{bending} {longer}");
}

/// A mesh that is stepped, with its responses to loads at all sites.
fn stepped(model: &Model) -> (SteppedString, Responses) {
    let mesh = SteppedString::new(
        &model.string,
        &model.bending,
        model.support,
        &model.sites,
        &model.parameters,
        model.sampling_frequency,
    )
    .unwrap();
    let loads: Vec<usize> = (0..model.sites.len()).collect();
    let longest = (STEPS - 1) as f64 / model.sampling_frequency;
    let responses = mesh.responses(&loads, longest).unwrap();
    (mesh, responses)
}

/// The largest difference of responses in one channel, over what the loaded site does.
fn difference_in_channel(taps: &ChannelResponses, stepped: &ChannelResponses) -> f64 {
    let mut worst: f64 = 0.0;
    for (taps, stepped) in taps.from_surface.iter().zip(&stepped.from_surface) {
        worst = worst.max(difference(taps, stepped) / peak(taps));
    }
    for (site, (taps, stepped)) in taps.from_loads.iter().zip(&stepped.from_loads).enumerate() {
        let scale = peak(&taps[site]);
        for (taps, stepped) in taps.iter().zip(stepped) {
            worst = worst.max(difference(taps, stepped) / scale);
        }
    }
    worst
}

/// The largest difference of a mesh that is stepped node by node, in torsion and bending: of
/// all that its sites do, within the step of a load and after, over what the loaded one does.
fn difference_when_stepped(model: &Model) -> f64 {
    let (bending, support) = (model.bending, model.support);
    let (mesh, stepped) = stepped(model);
    let torques = (0..model.sites.len()).collect();
    let torsion = model.taps(ChannelRequest::Torsion { torques }, 1);
    let bending = model.taps(ChannelRequest::Bending { bending, support }, 1);
    let in_torsion = difference_in_channel(&torsion, stepped.torsion().unwrap());
    let in_bending = difference_in_channel(&bending, stepped.bending().unwrap());
    let mut worst = in_torsion.max(in_bending);
    for (output, input) in (0..model.sites.len()).flat_map(|it| [(it, it), (0, it), (it, 0)]) {
        let instants = [
            (mesh.torsion().instant(output, input), &torsion),
            (mesh.bending().instant(output, input), &bending),
        ];
        for (instant, taps) in instants {
            let own = taps.from_loads[output][output][0];
            worst = worst.max((instant - taps.from_loads[output][input][0]).abs() / own);
        }
    }
    worst
}

/// The largest difference of a quantity at places by taps from that of elements that are stepped, over the
/// largest.
fn difference_at_places(model: &Model, (quantity, places): (PlaceQuantity, &[f64])) -> f64 {
    let (bending, support) = (model.bending, model.support);
    let request = Request {
        sites: model.sites.clone(),
        channels: vec![ChannelRequest::Bending { bending, support }],
        sampling_frequency: model.sampling_frequency,
        longest_time: (STEPS - 1) as f64 / model.sampling_frequency,
    };
    let method = Method::FiniteElement(model.parameters);
    let plan = PlacePlan::new(&model.string, &method, &request, (quantity, places)).unwrap();
    let taps = plan.build(&Budget::unlimited()).unwrap();
    let whole = WholeString {
        string: &model.string,
        bending: &model.bending,
        support,
        sites: &model.sites,
        sampling_frequency: model.sampling_frequency,
        parameters: model.parameters,
    };
    let count = model.sites.len();
    let largest = taps.from_forces.iter().flatten().map(|taps| peak(taps));
    let largest = largest.fold(0.0, f64::max);
    let mut worst: f64 = 0.0;
    for load in 0..count {
        let mut forces = [vec![vec![0.0; STEPS]; count], vec![vec![0.0; STEPS]; count]];
        forces[load % 2][load][0] = 1.0;
        let stepped = match quantity {
            PlaceQuantity::Displacement => whole.displacements(&forces, places, 3).unwrap(),
            PlaceQuantity::Moment => whole.moments(&forces, places, 3).unwrap(),
        };
        for (of_place, stepped) in taps.from_forces.iter().zip(&stepped) {
            let [driven, still] = [load % 2, 1 - load % 2].map(|axis| &stepped[axis]);
            assert_eq!(
                still.iter().fold(0.0, |most: f64, it| most.max(it.abs())),
                0.0
            );
            worst = worst.max(difference(&of_place[load][3..STEPS], driven) / largest);
        }
    }
    worst
}

/// A mesh that is stepped has the responses of its taps.
#[test]
fn val_the_papers_string_stepped_answers_as_its_taps_do() {
    let string = academic::string();
    for support in [
        SurfaceSupport::Free,
        SurfaceSupport::Pinned,
        SurfaceSupport::Clamped,
    ] {
        let model = Model {
            sites: Sites::new(&string, &[0.0, 3.0, 36.0, 250.0, 995.0]).unwrap(),
            string: string.clone(),
            parameters: FiniteElement::default(),
            sampling_frequency: academic::SAMPLING_FREQUENCY,
            bending: academic::BENDING,
            support,
        };
        let worst = difference_when_stepped(&model);
        assert!(worst < 1e-8, "{support:?}: {worst}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, ..Default::default() })]

    /// Steps lose more by short elements, as the fourth power of their length: 1e-9 by those of
    /// 0.1 m, 1e-5 by those of 0.01 m.
    #[test]
    fn val_taps_of_any_string_are_those_of_stepping_all_of_it(model in any_model()) {
        let torsion = model.difference_in_torsion();
        prop_assert!(torsion < 1e-9, "torsion: {torsion}");
        let [bending, longer] = model.differences_in_bending();
        prop_assert!(bending < 1e-7, "bending: {bending}");
        prop_assert!(longer < 1e-9, "bending, other ζ: {longer}");
    }

    /// Moments found without a step, and those that keep elements in equilibrium which are stepped:
    /// at sites, and between them. (Of a string that moves as a rigid rod, rounding bends elements.)
    #[test]
    fn val_moments_and_displacements_of_any_string_are_those_of_its_elements_stepped(
        model in any_model(),
        parts in prop::collection::vec(0.01..0.99f64, 1..4),
    ) {
        let model = Model { support: SurfaceSupport::Clamped, ..model };
        let at_sites = model.sites.distances_from_bit();
        let mut places: Vec<f64> = parts.iter().map(|part| part * model.string.length()).collect();
        places.extend_from_slice(at_sites);
        places.sort_by(|one, other| other.total_cmp(one));
        places.dedup_by(|one, other| (*one - *other).abs() < 0.3);
        for quantity in [PlaceQuantity::Moment, PlaceQuantity::Displacement] {
            let worst = difference_at_places(&model, (quantity, &places));
            prop_assert!(worst < 1e-7, "{quantity:?} {worst}");
        }
    }

    /// A top drive is stepped with the elements: what it is to them is what it is to their taps.
    #[test]
    fn val_any_string_stepped_below_a_drive_answers_as_its_taps_do(
        model in any_model(),
        inertia in prop_oneof![Just(0.0), 1.0..5000.0f64],
        proportional_gain in 1.0..2000.0f64,
        integral_gain in prop_oneof![Just(0.0), 1.0..2000.0f64],
    ) {
        let drive = TopDrive { inertia, proportional_gain, integral_gain, delay: 0.0, late_inertia: 0.0 };
        let string = model.string.clone().with_top_drive(drive).unwrap();
        let model = Model { string, ..model };
        let torques = (0..model.sites.len()).collect();
        let taps = model.taps(ChannelRequest::Torsion { torques }, 1);
        let (_, stepped) = stepped(&model);
        let worst = difference_in_channel(&taps, stepped.torsion().unwrap());
        prop_assert!(worst < 1e-7, "{worst}");
    }

    /// So has any other string; short elements cost it digits too.
    #[test]
    fn val_any_string_stepped_answers_as_its_taps_do(model in any_model()) {
        let worst = difference_when_stepped(&model);
        prop_assert!(worst < 1e-7, "{worst}");
    }

    /// And any string with loss that fades, in a hole that is wider above.
    #[test]
    fn val_any_string_with_loss_stepped_answers_as_its_taps_do(
        model in any_model(),
        viscosity in prop_oneof![Just(0.0), 0.001..0.3f64],
        loss_factor in prop_oneof![Just(0.0), 1e-4..0.05f64],
    ) {
        let length = model.string.length();
        let wide = HoleSection { length: 0.3 * length, radius: 0.3 };
        let narrow = HoleSection { length, radius: 0.2 };
        let mud = Mud { density: 1200.0, viscosity };
        let string = (model.string.clone().in_hole(Hole { sections: vec![wide, narrow], mud }))
            .and_then(|string| string.with_loss_factor(loss_factor))
            .unwrap();
        let worst = difference_when_stepped(&Model { string, ..model });
        prop_assert!(worst < 1e-7, "{worst}");
    }
}
