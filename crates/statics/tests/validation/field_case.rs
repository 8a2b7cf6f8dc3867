//! The field assembly in its 12¼-inch hole, against cubic elements and an ODE solver that share
//! no code with the program, and agree with each other to 5e-5 N.

use linear::well::{Station, Survey};
use problems::field_assembly::{self, Touching};
use statics::{
    Bit, Conditions, Contact, ContactState, Course, LyingString, StaticState, StaticsError, Top,
};

/// Inclination, deg, weight on bit, kN, whether the hole builds by 3°/30 m, whether the bit is pinned.
#[derive(Debug, Clone, Copy)]
struct Case(f64, f64, bool, bool);

const TO: f64 = 250.0;

impl Case {
    fn course(self) -> Course {
        let Self(degrees, _, builds, _) = self;
        let inclination = degrees.to_radians();
        if !builds {
            return Course::Straight { inclination };
        }
        let length = field_assembly::string().length();
        let station = |measured_depth: f64, degrees: f64| Station {
            measured_depth,
            inclination: degrees.to_radians(),
            azimuth: 0.7,
        };
        let stations = vec![
            station(0.0, degrees - 30.0),
            station(length - 300.0, degrees - 30.0),
            station(length, degrees),
        ];
        Course::Surveyed(Survey::new(stations).unwrap())
    }

    fn conditions(self) -> Conditions {
        Conditions {
            mud: Some(field_assembly::MUD),
            weight_on_bit: 1e3 * self.1,
            bit: if self.3 { Bit::Pinned } else { Bit::Contact },
            top: Top::At(TO),
            ..Conditions::new(field_assembly::YOUNGS_MODULUS, self.course())
        }
    }

    fn lying(self, touching: &[Touching], stiffness: Option<f64>) -> LyingString {
        let string = field_assembly::string();
        LyingString::new(&string, &self.conditions(), &contacts(touching, stiffness)).unwrap()
    }
}

/// Contacts where a string may touch, rigid or of a stiffness.
fn contacts(touching: &[Touching], stiffness: Option<f64>) -> Vec<Contact> {
    let contact = |it: &Touching| Contact {
        distance_from_bit: it.distance_from_bit,
        clearance: it.clearance,
        radius: it.radius,
        stiffness,
    };
    touching.iter().map(contact).collect()
}

/// Force of the wall at a distance from the bit, N, positive inwards.
fn inward(state: &StaticState, distance: f64) -> f64 {
    nearest(state, distance).normal()
}

/// The contact at a distance from the bit, m.
fn nearest(state: &StaticState, distance: f64) -> &ContactState {
    let off = |it: &ContactState| (it.contact.distance_from_bit - distance).abs();
    let nearest = state
        .contacts()
        .iter()
        .min_by(|a, b| off(a).total_cmp(&off(b)));
    nearest.filter(|it| off(it) < 6e-3).unwrap()
}

#[track_caller]
fn assert_near(found: f64, expected: f64, tolerance: f64, what: impl std::fmt::Debug) {
    let off = (found / expected - 1.0).abs();
    assert!(
        off <= tolerance,
        "{found}, not {expected}, of {what:?}: {off:.1e}"
    );
}

/// A case; forces at [`RIGID_AT`]; y (mm) at the two places that do not touch; the greatest moment
/// (N m) and stress of bending (MPa) up to 60 m, each with where.
type RigidRow = (Case, [f64; 5], [f64; 2], (f64, f64), (f64, f64));

const RIGID_AT: [f64; 5] = [0.0, 4.735, 15.625, 29.43, 38.54];

#[rustfmt::skip]
const RIGID: [RigidRow; 16] = [
    (Case(30.0, 0.0, false, false), [425.6394, 6327.142, 12386.858, 19148.705, 10645.419], [-0.42660, -9.75640], (33603.936, 29.43), (24.39801, 29.43)),
    (Case(30.0, 0.0, false, true), [740.8537, 5836.087, 12604.335, 19085.686, 10674.438], [-0.38657, -9.77275], (33453.703, 29.43), (24.28893, 29.43)),
    (Case(30.0, 100.0, false, false), [413.8492, 6332.917, 12410.057, 18804.392, 10320.861], [-0.43430, -9.74587], (33488.686, 29.43), (24.31433, 29.43)),
    (Case(30.0, 100.0, false, true), [689.1443, 5884.188, 12625.883, 18739.465, 10351.490], [-0.39190, -9.76335], (33330.835, 29.43), (24.19972, 29.43)),
    (Case(60.0, 0.0, false, false), [952.1557, 10333.697, 22984.199, 30925.560, 17358.754], [-2.13428, -9.71477], (46185.973, 29.43), (33.53315, 29.43)),
    (Case(60.0, 0.0, false, true), [1266.7874, 9843.494, 23201.381, 30862.455, 17387.932], [-2.09397, -9.73128], (46034.982, 29.43), (33.42352, 29.43)),
    (Case(60.0, 100.0, false, false), [942.3327, 10322.652, 23019.845, 30614.448, 16959.000], [-2.18804, -9.68908], (46255.762, 29.43), (33.58382, 29.43)),
    (Case(60.0, 100.0, false, true), [1217.0316, 9874.802, 23235.362, 30549.424, 16989.800], [-2.14534, -9.70673], (46097.084, 29.43), (33.46861, 29.43)),
    (Case(90.0, 0.0, false, false), [1146.4352, 11794.227, 26872.546, 35160.710, 19635.474], [-2.77532, -9.69266], (50820.007, 29.43), (36.89767, 29.43)),
    (Case(90.0, 0.0, false, true), [1460.2694, 11305.193, 27089.321, 35097.486, 19664.870], [-2.73462, -9.70938], (50667.970, 29.43), (36.78728, 29.43)),
    (Case(90.0, 100.0, false, false), [1137.4194, 11776.864, 26912.252, 34867.005, 19181.618], [-2.84550, -9.66375], (50967.229, 29.43), (37.00456, 29.43)),
    (Case(90.0, 100.0, false, true), [1411.3018, 11330.219, 27127.344, 34801.849, 19212.650], [-2.80238, -9.68163], (50807.409, 29.43), (36.88852, 29.43)),
    (Case(60.0, 0.0, true, false), [9465.3224, 2604.120, 22020.875, 30264.023, 4937.263], [-1.91470, -10.20718], (66010.252, 22.17), (61.79809, 46.31)),
    (Case(60.0, 0.0, true, true), [9779.9628, 2113.898, 22238.074, 30200.917, 4966.435], [-1.87440, -10.22369], (65862.220, 22.19), (62.30710, 9.06)),
    (Case(60.0, 100.0, true, false), [9654.4121, 4015.021, 24376.383, 32215.874, 5288.555], [-2.30641, -10.19996], (67979.794, 22.19), (62.66678, 9.06)),
    (Case(60.0, 100.0, true, true), [9929.1201, 3567.150, 24591.918, 32150.849, 5319.349], [-2.26373, -10.21759], (67823.118, 22.21), (63.55293, 9.06)),
];

/// A case; the greatest deflection (mm) from the chord between each two of [`SPANS`]; the lowest y
/// (mm) in the second and the fourth.
type SagRow = (Case, [f64; 5], [f64; 2]);

const SPANS: [[f64; 2]; 5] = [
    [0.0, 4.735],
    [4.735, 15.625],
    [15.625, 26.81],
    [15.625, 29.43],
    [29.43, 38.54],
];

#[rustfmt::skip]
const SAGS: [SagRow; 16] = [
    (Case(30.0, 0.0, false, false), [0.1986, -1.7625, -1.6523, 1.2244, 3.0393], [-3.35002, -2.68177]),
    (Case(30.0, 0.0, false, true), [0.0973, -2.1250, -1.5502, 1.2547, 3.0229], [-3.71248, -2.55801]),
    (Case(30.0, 100.0, false, false), [0.2046, -1.7907, -1.6745, 1.2187, 3.0494], [-3.37821, -2.70648]),
    (Case(30.0, 100.0, false, true), [0.1039, -2.1614, -1.5673, 1.2507, 3.0319], [-3.74895, -2.57643]),
    (Case(60.0, 0.0, false, false), [0.2736, -2.4564, -4.3800, -4.6810, 3.0580], [-4.04393, -6.26848]),
    (Case(60.0, 0.0, false, true), [0.1735, -2.8270, -4.2812, -4.5610, 3.0415], [-4.41454, -6.14850]),
    (Case(60.0, 100.0, false, false), [0.2795, -2.4749, -4.4795, -4.8102, 3.0838], [-4.06236, -6.39773]),
    (Case(60.0, 100.0, false, true), [0.1800, -2.8540, -4.3756, -4.6840, 3.0662], [-4.44148, -6.27148]),
    (Case(90.0, 0.0, false, false), [0.3007, -2.7089, -5.4118, -6.0738, 3.0871], [-4.29640, -7.66127]),
    (Case(90.0, 0.0, false, true), [0.2010, -3.0818, -5.3128, -5.9540, 3.0705], [-4.66927, -7.54150]),
    (Case(90.0, 100.0, false, false), [0.3066, -2.7238, -5.5402, -6.2419, 3.1165], [-4.31131, -7.82941]),
    (Case(90.0, 100.0, false, true), [0.2075, -3.1053, -5.4361, -6.1157, 3.0988], [-4.69277, -7.70323]),
    (Case(60.0, 0.0, true, false), [2.3651, -3.6485, -5.6551, -5.8353, 2.6079], [-5.23604, -7.42283]),
    (Case(60.0, 0.0, true, true), [2.2691, -4.0319, -5.5561, -5.7149, 2.5919], [-5.61945, -7.30237]),
    (Case(60.0, 100.0, true, false), [2.4057, -3.9284, -6.3330, -6.7298, 2.6339], [-5.51586, -8.31733]),
    (Case(60.0, 100.0, true, true), [2.3100, -4.3194, -6.2293, -6.6036, 2.6169], [-5.90690, -8.19111]),
];

/// A case; forces at [`HERTZIAN_AT`]; the greatest moment at a node of elements, N m.
type HertzianRow = (Case, [f64; 7], f64);

const HERTZIAN_AT: [f64; 7] = [0.0, 4.735, 15.625, 29.43, 38.54, 44.753, 54.296];

#[rustfmt::skip]
const HERTZIAN: [HertzianRow; 8] = [
    (Case(30.0, 0.0, false, false), [465.0555, 6264.4274, 12426.4920, 19142.1708, 10558.1884, 1031.4154, 5407.0799], 33454.180),
    (Case(30.0, 100.0, false, false), [447.0396, 6274.5363, 12451.0144, 18792.1783, 10264.1222, 1735.4818, 5326.2633], 33331.607),
    (Case(60.0, 0.0, false, false), [995.4084, 10268.2199, 23023.5236, 30904.9361, 17305.4421, 4869.3025, 7940.4646], 45992.810),
    (Case(60.0, 100.0, false, false), [977.1073, 10262.4506, 23061.8080, 30590.8506, 16929.4807, 5651.0866, 7805.6178], 46057.255),
    (Case(90.0, 0.0, false, false), [1191.1790, 11727.0629, 26912.5894, 35134.4744, 19599.3299, 6569.7299, 8794.8211], 50609.008),
    (Case(90.0, 100.0, false, false), [1172.9765, 11715.1908, 26955.5877, 34837.7716, 19168.6107, 7417.5155, 8614.9121], 50750.000),
    (Case(60.0, 0.0, true, false), [9366.9166, 2757.0066, 21995.9666, 30065.8569, 5295.1109, 13034.8758, 6473.2707], 66313.198),
    (Case(60.0, 100.0, true, false), [9573.9873, 4135.8254, 24367.8622, 32011.6051, 5660.7407, 15596.5446, 7776.5196], 68307.245),
];

/// Where the string may touch.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Model {
    Middle,
    Ends,
    Anywhere,
}

/// A case; where it may touch; forces at [`MODEL_AT`]; those beyond, to 60 m, each with where; the
/// moment at 29.43 m, or the greatest.
type ModelRow = (Case, Model, [f64; 4], &'static [(f64, f64)], f64);

const MODEL_AT: [f64; 4] = [0.0, 4.735, 15.625, 29.43];

#[rustfmt::skip]
const MODELS: [ModelRow; 24] = [
    (Case(30.0, 0.0, false, false), Model::Middle, [425.64, 6327.14, 12386.86, 19148.70], &[(38.54, 10645.0), (44.75, 919.0), (54.30, 5467.0)], 33603.9),
    (Case(30.0, 0.0, false, false), Model::Ends, [420.26, 6342.83, 12348.29, 21482.82], &[(43.20, 11502.0), (55.85, 2708.0)], 33908.6),
    (Case(30.0, 0.0, false, false), Model::Anywhere, [420.41, 6342.39, 12349.39, 21478.92], &[(43.20, 11514.0), (55.85, 2649.0)], 33899.9),
    (Case(30.0, 100.0, false, false), Model::Middle, [413.85, 6332.92, 12410.06, 18804.39], &[(38.54, 10321.0), (44.75, 1655.0), (54.30, 5375.0)], 33488.7),
    (Case(30.0, 100.0, false, false), Model::Ends, [406.35, 6354.43, 12359.07, 21216.23], &[(43.20, 11535.0), (55.85, 2978.0)], 33883.7),
    (Case(30.0, 100.0, false, false), Model::Anywhere, [406.57, 6353.80, 12360.57, 21211.10], &[(43.20, 11549.0), (55.85, 2913.0)], 33872.1),
    (Case(60.0, 0.0, false, false), Model::Middle, [952.16, 10333.70, 22984.20, 30925.56], &[(38.54, 17359.0), (44.75, 4785.0), (54.30, 7990.0)], 46186.0),
    (Case(60.0, 0.0, false, false), Model::Ends, [853.97, 10619.76, 22283.91, 35855.82], &[(43.20, 20273.0), (55.85, 5220.0)], 51692.6),
    (Case(60.0, 0.0, false, false), Model::Anywhere, [853.54, 10621.00, 22280.87, 35866.48], &[(43.20, 20243.0), (55.01, 226.0), (55.85, 5052.0)], 51716.5),
    (Case(60.0, 100.0, false, false), Model::Middle, [942.33, 10322.65, 23019.84, 30614.45], &[(38.54, 16959.0), (44.75, 5592.0), (54.30, 7848.0)], 46255.8),
    (Case(60.0, 100.0, false, false), Model::Ends, [833.24, 10635.46, 22281.57, 35627.82], &[(43.20, 20252.0), (52.74, 130.0), (55.85, 5398.0)], 51948.0),
    (Case(60.0, 100.0, false, false), Model::Anywhere, [832.06, 10638.86, 22273.56, 35654.91], &[(43.20, 20183.0), (54.77, 950.0), (55.85, 4607.0)], 52009.7),
    (Case(90.0, 0.0, false, false), Model::Middle, [1146.44, 11794.23, 26872.55, 35160.71], &[(38.54, 19635.0), (44.75, 6501.0), (54.30, 8840.0)], 50820.0),
    (Case(90.0, 0.0, false, false), Model::Ends, [1009.98, 12191.45, 25905.39, 41096.91], &[(43.20, 23346.0), (52.74, 307.0), (55.85, 6020.0)], 58377.8),
    (Case(90.0, 0.0, false, false), Model::Anywhere, [1009.06, 12194.14, 25898.86, 41119.56], &[(43.20, 23287.0), (54.65, 1290.0), (55.85, 5060.0)], 58428.9),
    (Case(90.0, 100.0, false, false), Model::Middle, [1137.42, 11776.86, 26912.25, 34867.01], &[(38.54, 19182.0), (44.75, 7372.0), (54.30, 8655.0)], 50967.2),
    (Case(90.0, 100.0, false, false), Model::Ends, [985.18, 12213.07, 25888.51, 40912.33], &[(43.20, 23239.0), (52.74, 662.0), (55.85, 5973.0)], 58808.4),
    (Case(90.0, 100.0, false, false), Model::Anywhere, [986.02, 12210.67, 25894.13, 40892.90], &[(40.99, 155.0), (43.20, 23072.0), (54.50, 1833.0), (55.85, 4812.0)], 58765.4),
    (Case(60.0, 0.0, true, false), Model::Middle, [9465.32, 2604.12, 22020.88, 30264.02], &[(38.54, 4937.0), (44.75, 13252.0), (54.30, 6440.0)], 65999.7),
    (Case(60.0, 0.0, true, false), Model::Ends, [9586.78, 2250.26, 22887.27, 29101.81], &[(43.20, 18975.0), (52.74, 3844.0), (55.85, 2436.0)], 68276.9),
    (Case(60.0, 0.0, true, false), Model::Anywhere, [9586.78, 2250.26, 22887.27, 29101.81], &[(43.20, 18975.0), (52.74, 3844.0), (55.85, 2436.0)], 68275.9),
    (Case(60.0, 100.0, true, false), Model::Middle, [9654.41, 4015.02, 24376.38, 32215.87], &[(38.54, 5289.0), (44.75, 15824.0), (54.30, 7742.0)], 67973.7),
    (Case(60.0, 100.0, true, false), Model::Ends, [9779.38, 3656.68, 25222.26, 31276.90], &[(43.20, 21066.0), (52.74, 5463.0), (55.85, 2906.0)], 70293.2),
    (Case(60.0, 100.0, true, false), Model::Anywhere, [9779.38, 3656.68, 25222.26, 31276.90], &[(43.20, 21066.0), (52.74, 5463.0), (55.85, 2906.0)], 70293.1),
];

#[test]
fn val_the_field_string_lies_on_rigid_contacts_as_by_elements_and_by_an_ode() {
    for (case, forces, [low, next], (moment, moment_at), (stress, stress_at)) in RIGID {
        let state = case
            .lying(&field_assembly::middles(TO), None)
            .at_rest()
            .unwrap();
        assert!(state.is_stable(), "{case:?}");
        for (distance, force) in RIGID_AT.into_iter().zip(forces) {
            assert_near(inward(&state, distance), force, 1e-6, (case, distance));
        }
        for (distance, y) in [(26.81, low), (32.615, next)] {
            assert_eq!(inward(&state, distance), 0.0);
            assert_near(
                1e3 * state.at(distance).displacement[0],
                y,
                2e-5,
                (case, distance),
            );
        }
        let found = state.greatest_moment(60.0);
        assert_near(found.1, moment, 2e-6, case);
        assert!((found.0 - moment_at).abs() < 0.02, "{case:?}: {}", found.0);
        let found = state.greatest_bending_stress(60.0);
        assert_near(found.1, 1e6 * stress, 2e-6, case);
        assert!((found.0 - stress_at).abs() < 0.02, "{case:?}: {}", found.0);
    }
}

#[test]
fn val_the_field_string_sags_between_its_contacts_as_by_an_ode() {
    for (case, sags, lowest) in SAGS {
        let state = case
            .lying(&field_assembly::middles(TO), None)
            .at_rest()
            .unwrap();
        let y = |distance: f64| 1e3 * state.at(distance).displacement[0];
        let along = |[from, to]: [f64; 2]| {
            (0..=2000).map(move |step| from + (to - from) * f64::from(step) / 2000.0)
        };
        for (span, sag) in SPANS.into_iter().zip(sags) {
            let [from, to] = span;
            let off =
                |place: f64| y(place) - y(from) - (y(to) - y(from)) * (place - from) / (to - from);
            let found = along(span).map(off);
            let found = found.max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap();
            // Their chord to 26.81 m, which is no contact, ends next to it.
            let tolerance = if span[1] == 26.81 {
                7e-4 * sag.abs()
            } else {
                1.2e-4
            };
            assert!(
                (found - sag).abs() < tolerance,
                "{case:?}, {span:?}: {found}, not {sag}"
            );
        }
        for (span, expected) in [SPANS[1], SPANS[3]].into_iter().zip(lowest) {
            let found = along(span).map(y).fold(f64::INFINITY, f64::min);
            assert!(
                (found - expected).abs() < 2e-5,
                "{case:?}: {found}, not {expected}"
            );
        }
    }
}

#[test]
fn val_the_field_string_lies_on_hertzian_contacts_as_by_elements_and_by_an_ode() {
    for (case, forces, moment) in HERTZIAN {
        let state = case
            .lying(&field_assembly::middles(TO), Some(1e9))
            .at_rest()
            .unwrap();
        assert!(state.is_stable(), "{case:?}");
        for (distance, force) in HERTZIAN_AT.into_iter().zip(forces) {
            assert_near(inward(&state, distance), force, 1e-6, (case, distance));
        }
        // In a bend the greatest is between their nodes.
        assert_near(state.greatest_moment(60.0).1, moment, 2e-4, case);
    }
}

#[test]
fn val_where_it_may_touch_decides_what_the_field_string_lies_on() {
    for (case, model, forces, beyond, moment) in MODELS {
        let (touching, lowest, others) = match model {
            Model::Middle => (field_assembly::middles(TO), 1e-5, 1e-3),
            Model::Ends => (field_assembly::ends(TO), 1e-5, 4e-3),
            // How a joint shares its load between its ends is known to 5 %.
            Model::Anywhere => (field_assembly::anywhere(0.125, TO), 1e-3, f64::INFINITY),
        };
        let state = case.lying(&touching, None).at_rest().unwrap();
        assert!(state.is_stable(), "{case:?}");
        for (distance, force) in MODEL_AT.into_iter().zip(forces) {
            assert_near(
                inward(&state, distance),
                force,
                lowest,
                (case, model, distance),
            );
        }
        for &(distance, force) in beyond {
            if others.is_finite() {
                assert_near(
                    inward(&state, distance),
                    force,
                    others,
                    (case, model, distance),
                );
            }
        }
        // In a bend the greatest is between their nodes.
        let (found, tolerance) = match case.2 {
            true => (state.greatest_moment(60.0).1, 2e-4),
            false => (-state.at(29.43).moment[0], 2.0 * lowest),
        };
        assert_near(found, moment, tolerance, (case, model));
    }
}

/// Friction; the angle of climb, deg, and the force, N, at each of [`HERTZIAN_AT`]; the torque,
/// N m; the sum of all forces, N.
type SlidingRow = (f64, [(f64, f64); 7], f64, f64);

#[rustfmt::skip]
const SLIDING: [SlidingRow; 3] = [
    (0.1, [(4.9533, 990.426), (6.0256, 10216.072), (5.2528, 22917.740), (6.3281, 30735.798), (5.2381, 17236.512), (4.8488, 4837.389), (5.8710, 7907.323)], 2150.65, 181_652.14),
    (0.3, [(14.4325, 953.261), (17.6262, 9825.102), (15.3706, 22122.535), (18.5027, 29470.567), (15.3282, 16718.004), (14.1615, 4597.770), (17.1819, 7658.113)], 6211.97, 174_904.70),
    (0.6, [(26.5077, 854.632), (32.7107, 8771.469), (28.5528, 19959.903), (34.2975, 26086.103), (28.4761, 15304.356), (26.1486, 3949.104), (31.9259, 6979.497)], 11129.03, 156_694.88),
];

#[test]
fn val_in_steady_sliding_rotation_each_contact_climbs_by_its_own_angle() {
    let case = Case(60.0, 0.0, false, false);
    let lying = case.lying(&field_assembly::middles(TO), Some(1e9));
    for (friction, at, torque, sum) in SLIDING {
        let state = lying.sliding(friction).unwrap();
        let clockwise = state.contacts();
        for (distance, (climb, force)) in HERTZIAN_AT.into_iter().zip(at) {
            let it = nearest(&state, distance);
            assert!(
                (it.climb().to_degrees() - climb).abs() < 2e-4,
                "{friction}, {distance}"
            );
            assert_near(it.normal(), force, 1e-6, (friction, distance));
        }
        assert_near(state.friction_torque(), torque, 1e-4, friction);
        let found: f64 = clockwise.iter().map(ContactState::normal).sum();
        assert_near(found, sum, 1e-6, friction);
        // The other way round it climbs the other side.
        let mirrored = lying.sliding(-friction).unwrap();
        for (one, other) in clockwise.iter().zip(mirrored.contacts()) {
            assert!((one.force[0] - other.force[0]).abs() < 1e-3);
            assert!((one.force[1] + other.force[1]).abs() < 1e-3);
        }
    }
}

/// On rigid walls force and friction are balanced without any give.
#[test]
fn val_on_rigid_walls_a_sliding_string_is_what_it_is_on_very_stiff_ones() {
    let case = Case(60.0, 100.0, false, false);
    let rigid = case
        .lying(&field_assembly::middles(TO), None)
        .sliding(0.4)
        .unwrap();
    let stiff = case
        .lying(&field_assembly::middles(TO), Some(1e14))
        .sliding(0.4)
        .unwrap();
    for (one, other) in rigid.contacts().iter().zip(stiff.contacts()) {
        let [[x, y], [x1, y1]] = [one.force, other.force];
        assert!((x - x1).hypot(y - y1) < 5.0, "{one:?} {other:?}");
        if one.touches {
            let tangential = x.hypot(y).powi(2) - one.normal().powi(2);
            assert_near(tangential.sqrt(), 0.4 * one.normal(), 1e-6, one);
        }
    }
}

/// The weight on bit, kN, from which the field string does not stay in its plane, by its
/// inclination (deg).
#[test]
fn val_the_field_string_snakes_beyond_a_weight_on_bit() {
    for (degrees, expected) in [(30.0, 325.5), (60.0, 302.8), (90.0, 222.1)] {
        let case = Case(degrees, 0.0, false, false);
        let lying = case.lying(&field_assembly::middles(TO), None);
        let unstable = |kn: f64| {
            lying
                .under(1e3 * kn)
                .at_rest()
                .unwrap()
                .unstable_directions()
        };
        assert_eq!(unstable(expected - 0.2), [0, 0], "{degrees}");
        assert_eq!(unstable(expected + 0.2), [0, 1], "{degrees}");
        let found = lying.snaking_weight(1e6).unwrap().unwrap();
        assert!((1e-3 * found - expected).abs() < 0.1, "{degrees}: {found}");
        assert_eq!(lying.snaking_weight(2e5), Ok(None));
    }
}

#[test]
fn val_the_field_string_buckles_freely_and_between_its_contacts_as_by_elements() {
    // Vertical; horizontal, under none.
    let case = |degrees| Case(degrees, 0.0, false, false);
    let lying = case(0.0).lying(&field_assembly::middles(TO), None);
    assert!(!lying.under(43.1e3).buckles_without_contacts());
    assert!(lying.under(43.3e3).buckles_without_contacts());
    for (degrees, expected) in [(0.0, 433.8), (90.0, 252.07)] {
        let lying = case(degrees).lying(&field_assembly::middles(TO), None);
        let held = |kn: f64| lying.under(1e3 * kn).buckles_between_contacts();
        assert!(
            !held(0.999 * expected) && held(1.001 * expected),
            "{degrees}"
        );
        let under = lying.under(2e6).at_rest();
        assert!(matches!(
            under,
            Err(StaticsError::BucklesBetweenContacts { .. })
        ));
    }
}

/// Halving the elements changes nothing that is read off, and cutting higher up neither.
#[test]
fn val_forces_are_converged_in_the_length_of_elements_and_of_the_string() {
    let case = Case(60.0, 100.0, false, false);
    let of = |to: f64, longest: Option<f64>| {
        let conditions = Conditions {
            top: Top::At(to),
            longest_element: longest,
            ..case.conditions()
        };
        let contacts = contacts(&field_assembly::middles(to - 2.0), None);
        let lying = LyingString::new(&field_assembly::string(), &conditions, &contacts).unwrap();
        inward(&lying.at_rest().unwrap(), 38.54)
    };
    let coarse = of(250.0, None);
    assert_near(coarse, of(250.0, Some(0.125)), 1e-7, "finer");
    for (to, expected) in [
        (150.0, 16_959.009_247),
        (200.0, 16_958.999_991),
        (300.0, 16_958.999_973),
    ] {
        assert_near(of(to, Some(0.25)), expected, 2e-8, to);
    }
}

/// Where the string is cut of itself, above the highest contact, nothing changes at the lowest.
#[test]
fn val_a_cut_of_itself_is_far_enough_from_the_bit() {
    for ends in [false, true] {
        let case = Case(60.0, 100.0, false, false);
        let touching = |to: f64| match ends {
            true => field_assembly::ends(to),
            false => field_assembly::middles(to),
        };
        let expected = case.lying(&touching(TO), None).at_rest().unwrap();
        for to in [150.0, 200.0] {
            let conditions = Conditions {
                top: Top::default(),
                ..case.conditions()
            };
            let contacts = contacts(&touching(to), None);
            let string = field_assembly::string();
            let lying = LyingString::new(&string, &conditions, &contacts).unwrap();
            let state = lying.at_rest().unwrap();
            assert!(state.top() > to - 10.0);
            for distance in [0.0, 4.735, 15.625, 29.43] {
                let force = inward(&expected, distance);
                assert_near(inward(&state, distance), force, 1e-4, (ends, to, distance));
            }
        }
    }
}

/// Where contacts end low the string lies on its wall next above them, and the lowest bear the same: cut at
/// 150 m it would hang through its wall, and all that weight on the highest.
#[test]
fn val_the_lowest_contacts_bear_the_same_wherever_contacts_end() {
    let case = Case(60.0, 0.0, false, false);
    let expected = case
        .lying(&field_assembly::ends(TO), None)
        .at_rest()
        .unwrap();
    let heaviest = inward(&expected, 29.43);
    assert!(heaviest > 3e4, "{heaviest}");
    for to in [60.0, 85.0, 112.0] {
        let conditions = Conditions {
            top: Top::AboveContacts,
            ..case.conditions()
        };
        let contacts = contacts(&field_assembly::ends(to), None);
        let string = field_assembly::string();
        let lying = LyingString::new(&string, &conditions, &contacts).unwrap();
        let state = lying.at_rest().unwrap();
        assert!(state.top() < to + 10.0, "{}", state.top());
        for distance in [0.0, 4.735, 15.625, 29.43] {
            let apart = inward(&state, distance) - inward(&expected, distance);
            assert!(apart.abs() < 0.01 * heaviest, "{to} {distance}: {apart}");
        }
    }
}
