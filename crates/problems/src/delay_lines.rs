//! A bit that cuts below exact delay lines, in small explicit steps: waves arrive, torque and
//! weight answer where the bit stands at the beginning of a step, and its speeds carry it to the
//! end. The rock is a ring of cells. Neither a response nor an equation of the library's steps is in
//! it.

/// Waves of one motion on a row of tubes without loss: in torsion (N m s/rad, rad/s, N m), or along
/// the axis (N s/m, m/s, N).
#[derive(Debug, Clone)]
pub struct Waves {
    /// η: the upper end sends back −η of a wave.
    sent_back: f64,
    /// What the upper end is set to.
    surface_speed: f64,
    tubes: Vec<Piece>,
}

/// A tube, with the waves in it.
#[derive(Debug, Clone)]
struct Piece {
    impedance: f64,
    down: Delay,
    up: Delay,
}

/// What enters comes out later.
#[derive(Debug, Clone)]
struct Delay {
    /// The last values, each at its step in a ring.
    values: Vec<f64>,
    next: usize,
    /// How far beyond a whole number of steps, in parts of one.
    beyond: f64,
}

impl Delay {
    /// Of a number of steps, full of one value.
    fn new(steps: f64, value: f64) -> Self {
        let near_whole = (steps - steps.round()).abs() < 1e-9 * steps;
        let whole = if near_whole {
            steps.round()
        } else {
            steps.floor()
        };
        Self {
            values: vec![value; whole as usize + 1],
            next: 0,
            beyond: if near_whole { 0.0 } else { steps - whole },
        }
    }

    /// What comes out in this step.
    fn arriving(&self) -> f64 {
        let [oldest, newer] = [self.next, self.next + 1].map(|at| {
            let count = self.values.len();
            self.values[if at >= count { at - count } else { at }]
        });
        newer + self.beyond * (oldest - newer)
    }

    fn enter(&mut self, value: f64) {
        self.values[self.next] = value;
        self.next += 1;
        if self.next == self.values.len() {
            self.next = 0;
        }
    }

    /// The sum of squares of what is inside, where it is a whole number of steps long.
    fn squares(&self) -> f64 {
        let all: f64 = self.values.iter().map(|value| value * value).sum();
        all - self.values[self.next].powi(2)
    }
}

impl Waves {
    /// Steadily moving at a speed, under a load: tubes from the surface down by their impedance and
    /// travel time (s), in steps of a time (s).
    pub fn steady(tubes: &[[f64; 2]], sent_back: f64, step: f64, [speed, load]: [f64; 2]) -> Self {
        let piece = |&[impedance, travel_time]: &[f64; 2]| {
            let wave =
                |sign: f64| Delay::new(travel_time / step, 0.5 * (speed + sign * load / impedance));
            Piece {
                impedance,
                down: wave(1.0),
                up: wave(-1.0),
            }
        };
        let above = tubes[0][0] * (1.0 + sent_back) / (1.0 - sent_back);
        Self {
            sent_back,
            surface_speed: speed + load / above,
            tubes: tubes.iter().map(piece).collect(),
        }
    }

    /// Of the lowest tube.
    pub fn impedance(&self) -> f64 {
        self.tubes[self.tubes.len() - 1].impedance
    }

    /// Speed of the lower end in this step if nothing acted on it.
    pub fn free_speed(&self) -> f64 {
        2.0 * self.tubes[self.tubes.len() - 1].down.arriving()
    }

    /// Ends a step in which the lower end moved at a speed. Gives the work that the surface has put in
    /// and what its dashpot has lost, per time.
    pub fn end_step(&mut self, speed: f64) -> [f64; 2] {
        let last = self.tubes.len() - 1;
        let arriving = self.tubes[0].up.arriving();
        let mut leaving =
            0.5 * (1.0 + self.sent_back) * self.surface_speed - self.sent_back * arriving;
        let force = self.tubes[0].impedance * (leaving - arriving);
        let powers = [
            force * self.surface_speed,
            force * (self.surface_speed - leaving - arriving),
        ];
        for at in 1..=last {
            let [above, below] = [self.tubes[at - 1].impedance, self.tubes[at].impedance];
            let [down, up] = [
                self.tubes[at - 1].down.arriving(),
                self.tubes[at].up.arriving(),
            ];
            let node = 2.0 * (above * down + below * up) / (above + below);
            self.tubes[at - 1].down.enter(leaving);
            self.tubes[at - 1].up.enter(node - down);
            leaving = node - up;
        }
        let down = self.tubes[last].down.arriving();
        self.tubes[last].down.enter(leaving);
        self.tubes[last].up.enter(speed - down);
        powers
    }

    /// Energy of all waves, J, in steps of a time (s) of which tubes are whole numbers long.
    pub fn energy(&self, step: f64) -> f64 {
        let of = |tube: &Piece| tube.impedance * step * (tube.down.squares() + tube.up.squares());
        self.tubes.iter().map(of).sum()
    }
}

/// How the rock answers a bit of blades that are evenly spaced.
#[derive(Debug, Clone, Copy)]
pub struct Rock {
    /// Torque and weight per depth of cut, N m/m and N/m.
    pub stiffnesses: [f64; 2],
    /// What wear flats carry at most, N, and per depth of cut until then, N/m: infinite at once.
    pub flats: f64,
    /// How fast that grows.
    pub growth: f64,
    /// Torque per what flats carry, m.
    pub flat_radius: f64,
    /// Angle from one blade to the next, rad.
    pub apart: f64,
    /// The most advance per angle, m/rad.
    pub relief: f64,
}

impl Rock {
    /// Torque and weight of steady drilling at a depth of cut.
    pub fn steady(&self, depth: f64) -> [f64; 2] {
        let flat = self.carried(depth);
        [
            self.stiffnesses[0] * depth + self.flat_radius * flat,
            self.stiffnesses[1] * depth + flat,
        ]
    }

    fn carried(&self, depth: f64) -> f64 {
        match (depth >= 0.0, self.growth.is_finite()) {
            (false, _) => 0.0,
            (true, false) => self.flats,
            (true, true) => (self.growth * depth).min(self.flats),
        }
    }
}

/// What a bit does in a step.
#[derive(Debug, Clone, Copy, Default)]
pub struct Moment {
    /// rad/s.
    pub speed: f64,
    /// m/s.
    pub rate: f64,
    /// N m.
    pub torque: f64,
    /// N.
    pub weight: f64,
    /// m; negative off bottom.
    pub depth_of_cut: f64,
}

/// A bit that cuts below delay lines.
#[derive(Debug, Clone)]
pub struct CuttingBit {
    torsion: Waves,
    axial: Waves,
    rock: Rock,
    step: f64,
    face: Ring,
    angle: f64,
    depth: f64,
    deepest: f64,
}

impl CuttingBit {
    /// A bit that drills steadily at a speed (rad/s) and a rate (m/s), below tubes in torsion and along
    /// the axis, each by impedance and travel time (s), that send back −η, in steps of a time (s).
    pub fn drilling(
        rock: Rock,
        [torsion, axial]: [&[[f64; 2]]; 2],
        [eta_t, eta_a]: [f64; 2],
        [speed, rate]: [f64; 2],
        step: f64,
    ) -> Self {
        let [torque, weight] = rock.steady(rate / speed * rock.apart);
        Self {
            torsion: Waves::steady(torsion, eta_t, step, [speed, torque]),
            axial: Waves::steady(axial, eta_a, step, [rate, weight]),
            rock,
            step,
            face: Ring::new(rock.apart, rate / speed, speed * step),
            angle: 0.0,
            depth: 0.0,
            deepest: 0.0,
        }
    }

    /// A step, under a torque (N m, with the rotation) and a force (N, down) on the bit.
    pub fn advance(&mut self, [torque, force]: [f64; 2]) -> Moment {
        let Rock {
            stiffnesses: [per_torque, per_weight],
            ..
        } = self.rock;
        let depth_of_cut = self.depth - self.face.ahead(self.angle);
        let cut = depth_of_cut.max(0.0);
        // What is above the rock by less than it falls in this step lands on its flats.
        let lands = -depth_of_cut.min(0.0) / self.step;
        let most = self.rock.carried(depth_of_cut + self.step * lands);
        // Along the axis: down against all the flats can carry, up against none, or at rest.
        let impedance = self.axial.impedance();
        let pressed = impedance * self.axial.free_speed() + force;
        let flat = (pressed - impedance * lands - per_weight * cut).clamp(0.0, most);
        let free = (pressed - per_weight * cut - flat) / impedance;
        // In torsion it turns, or stands.
        let resisting = per_torque * cut + self.rock.flat_radius * flat;
        let around = self.torsion.impedance();
        let driven = around * self.torsion.free_speed() + torque;
        let turning = (driven - resisting) / around;
        let is_held = depth_of_cut >= 0.0 && turning < 0.0;
        let speed = if is_held { 0.0 } else { turning };
        let room = (self.deepest - self.depth).max(-depth_of_cut).max(0.0);
        let sinks = match speed > 0.0 && self.rock.relief.is_finite() {
            true => self.rock.relief * speed,
            false if speed > 0.0 => f64::INFINITY,
            false => 0.0,
        };
        let rate = free.min(sinks + room / self.step);
        let now = Moment {
            speed,
            rate,
            torque: driven - around * speed,
            weight: pressed - impedance * rate,
            depth_of_cut,
        };
        self.torsion.end_step(speed);
        self.axial.end_step(rate);
        self.angle += self.step * speed;
        self.depth += self.step * rate;
        self.face.leave(self.angle, self.depth);
        if speed > 0.0 || self.depth > self.deepest {
            self.deepest = self.depth;
        }
        now
    }
}

/// The rock from one blade to the next, in cells of a ring that the blade overwrites as it passes.
#[derive(Debug, Clone)]
struct Ring {
    cell: f64,
    depths: Vec<f64>,
    /// How many edges of cells the blade has passed, and how deep the rock was at the last of these.
    passed: usize,
    found: f64,
    /// The furthest angle, and what is left there.
    furthest: f64,
    left: f64,
}

/// Cells of a ring: about two to a step, within these bounds.
const CELLS: [f64; 2] = [200.0, 20_000.0];

impl Ring {
    /// As blades leave it that advance steadily per angle, m/rad, of which steps turn by an angle.
    fn new(apart: f64, advance: f64, turn: f64) -> Self {
        let cells = (2.0 * apart / turn).clamp(CELLS[0], CELLS[1]).round();
        let cell = apart / cells;
        let depth = |at: usize| advance * (at as f64 * cell - apart);
        let mut depths: Vec<f64> = (0..cells as usize).map(depth).collect();
        depths[0] = 0.0;
        Self {
            cell,
            depths,
            passed: 0,
            found: -advance * apart,
            furthest: 0.0,
            left: 0.0,
        }
    }

    fn at(&self, edge: usize) -> f64 {
        self.depths[edge % self.depths.len()]
    }

    /// Depth of the rock before a blade at an angle.
    fn ahead(&self, angle: f64) -> f64 {
        let start = self.passed as f64 * self.cell;
        let between = |low: f64, high: f64, part: f64| low + part * (high - low);
        if angle >= self.furthest {
            let part = (angle - start) / self.cell;
            return between(self.found, self.at(self.passed + 1), part);
        }
        if angle >= start {
            let part = (angle - start) / (self.furthest - start);
            return between(self.at(self.passed), self.left, part);
        }
        let edge = (angle / self.cell).max(0.0) as usize;
        let part = angle / self.cell - edge as f64;
        between(self.at(edge), self.at(edge + 1), part)
    }

    /// The blade is at an angle, and the bit at a depth.
    fn leave(&mut self, angle: f64, depth: f64) {
        if angle <= self.furthest {
            return;
        }
        let ([from, left], [to, leaves]) = ([self.furthest, self.left], [angle, depth]);
        while (self.passed + 1) as f64 * self.cell <= angle {
            self.passed += 1;
            let edge = self.passed as f64 * self.cell;
            let cuts = left + (leaves - left) * (edge - from) / (to - from);
            let place = self.passed % self.depths.len();
            self.found = self.depths[place];
            self.depths[place] = self.found.max(cuts);
        }
        self.furthest = angle;
        let start = self.passed as f64 * self.cell;
        let rock =
            self.found + (self.at(self.passed + 1) - self.found) * (angle - start) / self.cell;
        self.left = rock.max(depth);
    }
}
