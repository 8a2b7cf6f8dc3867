//! Which ports have walls.

/// The ports that bend, and so may have walls, numbered from the surface down.
#[derive(Debug, Clone)]
pub(crate) struct WallPorts {
    /// The port of each wall.
    ports: Vec<usize>,
    /// The wall of each port, where it has one.
    wall_of: Vec<Option<usize>>,
    /// Whether every port has the wall of its own number: then nothing has to be looked up.
    is_every_port: bool,
}

impl WallPorts {
    /// At these of a number of ports.
    pub(crate) fn new(ports: Vec<usize>, count: usize) -> Self {
        let mut wall_of = vec![None; count];
        for (wall, &port) in ports.iter().enumerate() {
            wall_of[port] = Some(wall);
        }
        Self {
            is_every_port: ports.iter().copied().eq(0..count),
            ports,
            wall_of,
        }
    }

    /// Number of walls.
    pub(crate) fn len(&self) -> usize {
        self.ports.len()
    }

    /// The port of each wall.
    pub(crate) fn ports(&self) -> &[usize] {
        &self.ports
    }

    /// Whether every port has a wall.
    #[inline]
    pub(crate) fn is_every_port(&self) -> bool {
        self.is_every_port
    }

    /// The wall of a port, where it has one.
    #[inline]
    pub(crate) fn at(&self, port: usize) -> Option<usize> {
        match self.is_every_port {
            true => Some(port),
            false => self.wall_of[port],
        }
    }
}
