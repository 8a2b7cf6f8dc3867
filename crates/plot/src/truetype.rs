//! Reader of a TrueType font: the glyph of a letter, its width and its outline, from the tables
//! `cmap`, `hmtx`, `loca` and `glyf`.
//!
//! It reads what the embedded font has, and nothing else: characters of two bytes (`cmap` in
//! format 4), short offsets, a width for each glyph, and glyphs put together from others that are
//! moved, but neither turned nor scaled. The tests of [`crate::font`] read every glyph of it.

/// Tables of a font.
pub(crate) struct TrueType {
    /// Font size in the units of all lengths in the file.
    pub(crate) units_per_em: u16,
    characters: &'static [u8],
    widths: &'static [u8],
    places: &'static [u8],
    outlines: &'static [u8],
}

/// Point of an outline, in units of the file.
#[derive(Clone, Copy)]
pub(crate) struct OutlinePoint {
    pub(crate) x: f32,
    pub(crate) y: f32,
    /// Whether the outline goes through it. Otherwise it controls a parabola.
    pub(crate) is_on: bool,
}

/// Closed curve that begins on the outline; between two points on it lies at most one off it.
pub(crate) type Contour = Vec<OutlinePoint>;

impl TrueType {
    /// Tables of a file, where it has all that are needed in the form that is read.
    pub(crate) fn parse(file: &'static [u8]) -> Option<Self> {
        let head = table(file, b"head")?;
        let has_short_offsets = u16_at(head, 50)? == 0;
        let characters = table(file, b"cmap")?;
        let characters = characters.get(u32_at(characters, 8)?..)?;
        let is_known = has_short_offsets && u16_at(characters, 0)? == 4;
        is_known.then_some(Self {
            units_per_em: u16_at(head, 18)?,
            characters,
            widths: table(file, b"hmtx")?,
            places: table(file, b"loca")?,
            outlines: table(file, b"glyf")?,
        })
    }

    /// Number of the glyph of a letter.
    pub(crate) fn glyph(&self, letter: char) -> Option<u16> {
        let code = u16::try_from(u32::from(letter)).ok()?;
        let table = self.characters;
        let size = usize::from(u16_at(table, 6)?);
        // Ends, starts, differences and offsets of the segments, in this order.
        let column = |part: usize, at: usize| 14 + part * size + at + if part > 0 { 2 } else { 0 };
        let mut segments = (0..size).step_by(2);
        let at =
            segments.find(|at| u16_at(table, column(0, *at)).is_some_and(|end| end >= code))?;
        let from_start = code.checked_sub(u16_at(table, column(1, at))?)?;
        let difference = u16_at(table, column(2, at))?;
        let listed = match usize::from(u16_at(table, column(3, at))?) {
            0 => code,
            offset => u16_at(table, column(3, at) + offset + 2 * usize::from(from_start))?,
        };
        Some(listed.wrapping_add(difference))
    }

    /// Distance to the next letter.
    pub(crate) fn width(&self, glyph: u16) -> Option<u16> {
        u16_at(self.widths, 4 * usize::from(glyph))
    }

    /// Curves of a glyph, none where it is blank.
    pub(crate) fn contours(&self, glyph: u16) -> Option<Vec<Contour>> {
        let mut contours = Vec::new();
        self.add_contours(glyph, (0.0, 0.0), &mut contours)?;
        Some(contours)
    }

    fn add_contours(
        &self,
        glyph: u16,
        shift: (f32, f32),
        contours: &mut Vec<Contour>,
    ) -> Option<()> {
        let place = |glyph| Some(2 * usize::from(u16_at(self.places, 2 * glyph)?));
        let glyph = usize::from(glyph);
        let outline = self.outlines.get(place(glyph)?..place(glyph + 1)?)?;
        if outline.is_empty() {
            return Some(());
        }
        match usize::try_from(i16_at(outline, 0)?) {
            Ok(count) => add_simple(outline, count, shift, contours),
            Err(_) => self.add_parts(outline, shift, contours),
        }
    }

    /// Adds a glyph that is put together from others.
    fn add_parts(
        &self,
        outline: &[u8],
        shift: (f32, f32),
        contours: &mut Vec<Contour>,
    ) -> Option<()> {
        const WORDS: u16 = 0x01;
        const OFFSETS: u16 = 0x02;
        const SCALES: u16 = 0x08 | 0x40 | 0x80;
        const MORE: u16 = 0x20;
        let mut at = 10;
        loop {
            let flags = u16_at(outline, at)?;
            if flags & OFFSETS == 0 || flags & SCALES != 0 {
                return None;
            }
            let (x, y, size) = if flags & WORDS == 0 {
                let byte = |at: usize| Some(i16::from(i8::from_be_bytes([*outline.get(at)?])));
                (byte(at + 4)?, byte(at + 5)?, 6)
            } else {
                (i16_at(outline, at + 4)?, i16_at(outline, at + 6)?, 8)
            };
            let shift = (shift.0 + f32::from(x), shift.1 + f32::from(y));
            self.add_contours(u16_at(outline, at + 2)?, shift, contours)?;
            if flags & MORE == 0 {
                return Some(());
            }
            at += size;
        }
    }
}

/// Adds a glyph with its own `count` curves.
fn add_simple(
    outline: &[u8],
    count: usize,
    shift: (f32, f32),
    contours: &mut Vec<Contour>,
) -> Option<()> {
    const ON: u8 = 0x01;
    const REPEATED: u8 = 0x08;
    let ends = (0..count).map(|contour| Some(usize::from(u16_at(outline, 10 + 2 * contour)?)));
    let ends: Vec<usize> = ends.collect::<Option<_>>()?;
    let points = ends.last().map_or(0, |last| last + 1);
    let hints = usize::from(u16_at(outline, 10 + 2 * count)?);
    let mut at = 12 + 2 * count + hints;
    let mut flags = Vec::new();
    while flags.len() < points {
        let flag = *outline.get(at)?;
        let is_repeated = flag & REPEATED != 0;
        let repeats = if is_repeated {
            *outline.get(at + 1)?
        } else {
            0
        };
        flags.extend(std::iter::repeat_n(flag, 1 + usize::from(repeats)));
        at += 1 + usize::from(is_repeated);
    }
    flags.truncate(points);
    let x = coordinates(outline, &mut at, &flags, [0x02, 0x10], shift.0)?;
    let y = coordinates(outline, &mut at, &flags, [0x04, 0x20], shift.1)?;
    let mut begin = 0;
    for end in ends {
        let points = (begin..=end).map(|point| {
            let (x, y, is_on) = (x[point], y[point], flags[point] & ON != 0);
            OutlinePoint { x, y, is_on }
        });
        contours.push(closed(&points.collect::<Vec<_>>()));
        begin = end + 1;
    }
    Some(())
}

/// One coordinate of each point: a step of a byte with its sign in a flag, of two bytes, or none.
fn coordinates(
    outline: &[u8],
    at: &mut usize,
    flags: &[u8],
    [is_short, is_same]: [u8; 2],
    mut value: f32,
) -> Option<Vec<f32>> {
    let mut values = Vec::with_capacity(flags.len());
    for flag in flags {
        let (is_short, is_same) = (flag & is_short != 0, flag & is_same != 0);
        if is_short {
            let step = f32::from(*outline.get(*at)?);
            value += if is_same { step } else { -step };
            *at += 1;
        } else if !is_same {
            value += f32::from(i16_at(outline, *at)?);
            *at += 2;
        }
        values.push(value);
    }
    Some(values)
}

/// Curve with the points that a file leaves out, half-way between two that are off the outline.
fn closed(points: &[OutlinePoint]) -> Contour {
    let following = points.iter().cycle().skip(1);
    let mut contour = Vec::new();
    for (point, next) in points.iter().zip(following) {
        contour.push(*point);
        if !point.is_on && !next.is_on {
            let (x, y) = ((point.x + next.x) / 2.0, (point.y + next.y) / 2.0);
            contour.push(OutlinePoint { x, y, is_on: true });
        }
    }
    let first = contour.iter().position(|point| point.is_on).unwrap_or(0);
    contour.rotate_left(first);
    contour
}

/// Table of a font by its name.
fn table(file: &'static [u8], name: &[u8; 4]) -> Option<&'static [u8]> {
    let mut records = file.get(12..)?.chunks_exact(16);
    let record = records.find(|record| record.starts_with(name))?;
    let [begin, size] = [u32_at(record, 8)?, u32_at(record, 12)?];
    file.get(begin..begin.checked_add(size)?)
}

fn u16_at(bytes: &[u8], at: usize) -> Option<u16> {
    Some(u16::from_be_bytes(*bytes.get(at..)?.first_chunk()?))
}

fn i16_at(bytes: &[u8], at: usize) -> Option<i16> {
    Some(i16::from_be_bytes(*bytes.get(at..)?.first_chunk()?))
}

fn u32_at(bytes: &[u8], at: usize) -> Option<usize> {
    let number = u32::from_be_bytes(*bytes.get(at..)?.first_chunk()?);
    usize::try_from(number).ok()
}
