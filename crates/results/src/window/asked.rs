//! What is asked of an operating window.

/// What is asked of an operating window.
#[derive(Debug, Clone, PartialEq)]
pub struct WindowAsked {
    /// What shakes the string sideways, in multiples of its surface speed.
    pub orders: Vec<f64>,
    /// Places that hold the string sideways, from the bit, in m or, with field units, ft; where
    /// there are none, the sites of the file.
    pub held_at: Option<Vec<f64>>,
    /// The part by which a critical speed and the wall's friction may be off.
    pub margin: f64,
    /// Of random cases, the part with vibration up to which a cell is safe.
    pub risk: f64,
    /// Ranges of either axis that random cases are counted in.
    pub bins: usize,
    /// Whether axial chatter is safe while the bit stays in its rock.
    pub accept_chatter: bool,
}
