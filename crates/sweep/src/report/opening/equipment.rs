//! What turns in the hole, in a line each: string, bit, drive, mud, well and wall.

use crate::report::document::fact;
use crate::report::phrases::listed;
use crate::report::results::Results;
use campaign::quantities::{
    Axis, FORCE, INERTIA, LENGTH, StringAxis, TORQUE, Units, WIDTH, WallQuantity,
};
use campaign::sweep_file::bit::LawTable;
use campaign::sweep_file::{
    BitTable, ControllerName, FileContent, RockName, SectionTable, TopDriveTable,
};
use campaign::words::{counted, short};

/// Kinds of sections that are named; of more, the longest.
const MOST_SECTIONS: usize = 3;

/// String, bit, drive and mud, and the well where it is modelled.
pub fn equipment(results: &Results) -> Vec<(String, String)> {
    let manifest = &results.manifest;
    let content = &manifest.sweep;
    let is_varied = |axis: Axis| manifest.axes.contains(&axis);
    let mut facts = vec![
        fact("String", string(content)),
        fact("Bit", bit(content, &is_varied)),
        fact("Drive", drive(content)),
        fact("Mud", mud(content, &is_varied)),
    ];
    facts.extend(motor(content).map(|text| fact("Motor", text)));
    facts.extend(well(content, &is_varied).map(|text| fact("Well", text)));
    facts
}

fn string(content: &FileContent) -> String {
    let units = content.units;
    let length = units.of(&LENGTH);
    let metres = |value: f64| format!("{} {}", short(length.number(value).round()), length.name);
    let mut named: Vec<Named> = Vec::new();
    for (place, section) in content.string.sections.iter().enumerate() {
        let name = match &section.name {
            Some(name) => brief(name).to_owned(),
            None => format!("section {place}"),
        };
        let own = Named::of(name, section);
        match named.iter_mut().find(|other| other.name == own.name) {
            Some(other) => other.add(&own),
            None => named.push(own),
        }
    }
    named.sort_by(|one, other| other.length.total_cmp(&one.length));
    let mut parts: Vec<String> = (named.iter().take(MOST_SECTIONS))
        .map(|it| {
            format!(
                "{} of {} ({})",
                metres(it.length),
                it.name,
                it.across(units)
            )
        })
        .collect();
    let others: f64 = named.iter().skip(MOST_SECTIONS).map(|it| it.length).sum();
    if others > 0.0 {
        let count = named.len() - MOST_SECTIONS;
        parts.push(format!(
            "{} of {}",
            metres(others),
            counted(count, "other kind")
        ));
    }
    format!("{}: {}.", metres(length_of_string(content)), listed(&parts))
}

/// A name without what follows a colon or a semicolon.
fn brief(name: &str) -> &str {
    name.split([':', ';']).next().unwrap_or(name).trim()
}

/// Sections of one name.
struct Named {
    name: String,
    length: f64,
    /// The least and the greatest external radius, m.
    radii: [f64; 2],
}

impl Named {
    fn of(name: String, section: &SectionTable) -> Self {
        let radii = section.parts.iter().map(|part| part.outer_radius_m);
        let radii = radii.fold([f64::INFINITY, 0.0], |[least, most], radius| {
            [least.min(radius), radius.max(most)]
        });
        Self {
            name,
            length: length_of(section),
            radii,
        }
    }

    fn add(&mut self, other: &Self) {
        self.length += other.length;
        let ([least, most], [from, to]) = (self.radii, other.radii);
        self.radii = [least.min(from), most.max(to)];
    }

    /// The external diameters.
    fn across(&self, units: Units) -> String {
        let width = units.of(&WIDTH);
        let [from, to] = self.radii.map(|radius| short(width.number(2e3 * radius)));
        match from == to {
            true => format!("{to} {} across", width.name),
            false => format!("{from} to {to} {} across", width.name),
        }
    }
}

/// The length of the whole string, m.
pub fn length_of_string(content: &FileContent) -> f64 {
    content.string.sections.iter().map(length_of).sum()
}

fn length_of(section: &SectionTable) -> f64 {
    let cell: f64 = section.parts.iter().map(|part| part.length_m).sum();
    section.repeat as f64 * cell
}

fn bit(content: &FileContent, is_varied: &dyn Fn(Axis) -> bool) -> String {
    let Some(bit) = &content.bit else {
        return "off bottom: no torque on it.".to_owned();
    };
    let units = content.units;
    let mut parts = vec![rock(bit, units)];
    let force = units.of(&FORCE);
    if let Some(weight) = bit
        .weight_on_bit_kn
        .filter(|_| !is_varied(Axis::WeightOnBitKn))
    {
        let weight = short(force.number(weight));
        parts.push(format!("{weight} {} of weight", force.name));
    }
    if let Some(cutting) = &bit.cutting {
        let blades = cutting.blade_angles_deg.as_ref();
        let blades = counted(blades.map_or(cutting.blades, Vec::len), "blade");
        parts.push(format!(
            "{blades} that each cut what the one before has left"
        ));
        return format!("{}.", parts.join(", "));
    }
    if !is_varied(Axis::TorqueStaticRatio) {
        let ratio = short(bit.torque_static_ratio);
        parts.push(format!(
            "breaks loose at {ratio} times the torque at which it turns"
        ));
    }
    if bit.torque_decay_rpm > 0.0 && !is_varied(Axis::TorqueDecay) {
        let decay = short(bit.torque_decay_rpm);
        parts.push(format!("torque falls over {decay} rpm"));
    }
    format!("{}.", parts.join(", "))
}

fn rock(bit: &BitTable, units: Units) -> String {
    match (bit.rock, &bit.law) {
        (Some(RockName::Sandstone), _) => "in representative sandstone".to_owned(),
        (Some(RockName::Shale), _) => "in representative shale".to_owned(),
        (Some(RockName::Law), Some(LawTable { bit_radius_m, .. })) => {
            let width = units.of(&WIDTH);
            let across = short(width.number(2e3 * bit_radius_m));
            format!(
                "{across} {} across, in rock given by its constants",
                width.name
            )
        }
        (Some(_), _) => "torque over weight on bit as tabulated".to_owned(),
        (None, _) => match bit.torque_dynamic_nm {
            Some(torque) => {
                let unit = units.of(&TORQUE);
                format!("turns at {} {}", short(unit.number(torque)), unit.name)
            }
            None => "torque given case by case".to_owned(),
        },
    }
}

fn drive(content: &FileContent) -> String {
    if let Some(file) = &content.surface_speed_file {
        return format!("the surface turns as recorded in {file}.");
    }
    let Some(drive) = &content.top_drive else {
        return "the surface turns at its set speed, at any torque.".to_owned();
    };
    format!("{}.", controller(drive, content.units))
}

fn controller(drive: &TopDriveTable, units: Units) -> String {
    let kind = match drive.controller {
        ControllerName::Prescribed => return "turns at its set speed, at any torque".to_owned(),
        ControllerName::Stiff => "stiff speed controller",
        ControllerName::SoftTorque => "soft torque",
        ControllerName::ImpedanceMatched => "impedance-matched controller",
        ControllerName::Gains => "speed controller with given gains",
    };
    let inertia = units.of(&INERTIA);
    let own = short(inertia.number(drive.inertia_kg_m2));
    let mut parts = vec![format!("{kind}, inertia {own} {}", inertia.name)];
    let axes = [
        (
            StringAxis::ProportionalGain,
            drive.proportional_gain_knms_rad,
        ),
        (StringAxis::IntegralGain, drive.integral_gain_knm_rad),
    ];
    for (axis, gain) in axes {
        let axis = Axis::String(axis);
        let unit = axis.unit(units);
        parts.extend(gain.map(|gain| {
            let gain = short(unit.number(gain));
            format!(
                "{} {gain} {}",
                axis.words(units).to_lowercase().replace("k_", "K_"),
                unit.name
            )
        }));
    }
    if let (true, Some(limit)) = (drive.saturates, drive.torque_limit_kn_m) {
        parts.push(format!(
            "gives at most {}",
            units.of(&TORQUE).text(1e3 * limit, 0)
        ));
    }
    parts.join(", ")
}

fn motor(content: &FileContent) -> Option<String> {
    let motor = content.motor.as_ref()?;
    let torque = content.units.of(&TORQUE);
    let stall = short(torque.number(1e3 * motor.stall_torque_kn_m));
    Some(format!(
        "mud motor of {} rpm without load, stalls at {stall} {}.",
        short(motor.speed_rpm),
        torque.name
    ))
}

fn mud(content: &FileContent, is_varied: &dyn Fn(Axis) -> bool) -> String {
    let Some(mud) = &content.mud else {
        return "not modelled.".to_owned();
    };
    let density = (StringAxis::MudDensity, "density", mud.density_kg_m3);
    let viscosity = (StringAxis::MudViscosity, "viscosity", mud.viscosity_cp);
    let parts = [density, viscosity].map(|(axis, words, value)| {
        let axis = Axis::String(axis);
        let unit = axis.unit(content.units);
        match (is_varied(axis), value > 0.0) {
            (true, _) => format!("{words} as varied"),
            (false, true) => format!("{} {}", short(unit.number(value)), unit.name),
            (false, false) => format!("without {words}"),
        }
    });
    format!("{}.", parts.join(", "))
}

/// Its course, its wall and the friction along the string; none where nothing is said of them.
fn well(content: &FileContent, is_varied: &dyn Fn(Axis) -> bool) -> Option<String> {
    let units = content.units;
    let survey = content.well.as_ref().and_then(|well| well.survey.as_ref());
    let survey = survey.map(|file| format!("course as surveyed in {file}"));
    let width = units.of(&WIDTH);
    let wall = content.wall.as_ref().map(|wall| {
        let is_rigid = wall.stiffness_gn_m15.is_none_or(f64::is_infinite)
            && !is_varied(Axis::Wall(WallQuantity::Stiffness));
        let kind = if is_rigid { "rigid wall" } else { "wall" };
        let place = match wall.clearance_mm {
            Some(clearance) => format!("{} {} away", short(width.number(clearance)), width.name),
            None => "at the size of the hole".to_owned(),
        };
        let friction = match is_varied(Axis::FRICTION) {
            true => " with friction as varied".to_owned(),
            false => (wall.friction).map_or_else(String::new, |friction| {
                format!(" with friction {}", short(friction))
            }),
        };
        format!("{kind} {place}{friction}")
    });
    let friction = content.string_friction.as_ref().map(|friction| {
        let still = friction.static_coefficient.map(short);
        let still = still.unwrap_or_else(|| "as varied".to_owned());
        let sliding = (friction.dynamic_ratio < 1.0)
            .then(|| format!(", sliding {} of that", short(friction.dynamic_ratio)));
        format!(
            "friction along the string {still}{}",
            sliding.unwrap_or_default()
        )
    });
    let parts: Vec<String> = [survey, wall, friction].into_iter().flatten().collect();
    (!parts.is_empty()).then(|| format!("{}.", listed(&parts)))
}
