//! Checks that the coded data of a JPEG file are complete.
//!
//! The decoder silently fills missing data with the last colour and continues after a gap. So this pass walks through
//! the data once more, without computing a pixel (ITU-T T.81, annexes F and G): every block must decode, none may
//! remain, and nothing may be left over. Unknown variants of JPEG are left to the decoder.

use std::ops::ControlFlow;

/// Bytes that may stand between the data and the next marker: some writers align them.
const MOST_LEFT_OVER: usize = 64;

/// Bits of the largest difference and of the largest coefficient of 8-bit samples (tables F.1 and F.2).
const LARGEST_DC: u8 = 11;
const LARGEST_AC: u32 = 10;

/// What is wrong with the data of a JPEG file; `None` if they are whole, or of a kind that is not known here.
pub(super) fn damage(encoded: &[u8]) -> Option<String> {
    let mut file = JpegFile::default();
    let mut position = 2;
    loop {
        position += encoded.get(position..)?.iter().position(|&byte| byte == 0xFF)?;
        position += encoded[position..].iter().position(|&byte| byte != 0xFF)?;
        let marker = encoded[position];
        position += 1;
        if marker == 0xD9 {
            return file.frame?.missing();
        }
        if matches!(marker, 0x00 | 0x01 | 0xD0..=0xD8) {
            continue;
        }
        let length = usize::from(u16::from_be_bytes(*encoded.get(position..)?.first_chunk()?));
        let segment = encoded.get(position + 2..position + length)?;
        position += length;
        match marker {
            0xC4 => file.read_huffman_tables(segment)?,
            0xDB => file.read_quantisation_tables(segment)?,
            0xDD => file.restart_interval = usize::from(u16::from_be_bytes(*segment.first_chunk()?)),
            0xC0..=0xC2 => file.frame = Some(Frame::read(segment, marker == 0xC2)?),
            // Lossless, hierarchical, arithmetic coding; the number of lines given later.
            0xC3 | 0xC5..=0xCF | 0xDC => return None,
            0xDA => match file.read_scan(segment, &encoded[position..])? {
                ControlFlow::Continue(bytes) => position += bytes,
                ControlFlow::Break(fault) => return Some(fault),
            },
            _ => (),
        }
    }
}

/// Tables and frame as far as the file was read.
#[derive(Default)]
struct JpegFile {
    /// For DC and AC.
    huffman: [[Option<HuffmanTable>; 4]; 2],
    /// The step of the DC coefficient.
    steps: [i64; 4],
    restart_interval: usize,
    frame: Option<Frame>,
}

/// For the next 16 bits the length of the code they begin with and its symbol; length 0 where there is none.
struct HuffmanTable(Vec<(u8, u8)>);

struct Frame {
    progressive: bool,
    components: Vec<Component>,
    /// Columns and rows of MCUs.
    mcus: [usize; 2],
}

struct Component {
    id: u8,
    /// Blocks of an MCU.
    sampling: [usize; 2],
    /// Columns and rows of blocks within the picture.
    blocks: [usize; 2],
    quantisation: usize,
    /// For each block which coefficients are not zero: later scans of a progressive file add a bit to each of them.
    nonzero: Vec<u64>,
    /// For each coefficient how many bits were not sent yet; 255 before the first.
    unsent: [u8; 64],
}

/// A component of a scan: its number in the frame and its tables.
#[derive(Clone, Copy)]
struct Coded {
    component: usize,
    dc: usize,
    ac: usize,
}

/// Which coefficients a scan holds, and from which bit on.
#[derive(Clone, Copy)]
struct Band {
    first: usize,
    last: usize,
    refines: bool,
    low_bit: u8,
}

/// Why a block does not decode.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Fault {
    /// A marker comes before the block is complete.
    Ended,
    /// A code, a coefficient or a brightness that does not exist.
    Impossible,
}

impl JpegFile {
    fn read_huffman_tables(&mut self, mut segment: &[u8]) -> Option<()> {
        while let Some((&[kind, ref lengths @ ..], rest)) = segment.split_first_chunk::<17>() {
            let mut lookup = vec![(0, 0); 1 << 16];
            let (mut code, mut symbols) = (0, rest);
            for (length, &count) in (1..).zip(lengths) {
                let (own, others) = symbols.split_at_checked(usize::from(count))?;
                for &symbol in own {
                    lookup.get_mut(code..code + (1 << (16 - length)))?.fill((length as u8, symbol));
                    code += 1 << (16 - length);
                }
                symbols = others;
            }
            *self.huffman.get_mut(usize::from(kind >> 4))?.get_mut(usize::from(kind & 15))? =
                Some(HuffmanTable(lookup));
            segment = symbols;
        }
        Some(())
    }

    fn read_quantisation_tables(&mut self, mut segment: &[u8]) -> Option<()> {
        while let [kind, rest @ ..] = segment {
            let size = if kind >> 4 == 0 { 1 } else { 2 };
            let (table, others) = rest.split_at_checked(64 * size)?;
            let step = table[..size].iter().fold(0, |step, &byte| step << 8 | i64::from(byte));
            *self.steps.get_mut(usize::from(kind & 15))? = step;
            segment = others;
        }
        Some(())
    }

    /// Walks through the data of a scan: how many bytes they are, or what is wrong with them.
    fn read_scan(&mut self, segment: &[u8], data: &[u8]) -> Option<ControlFlow<String, usize>> {
        let frame = self.frame.as_mut()?;
        let (count, rest) = segment.split_first()?;
        let (selectors, band) = rest.split_at_checked(2 * usize::from(*count))?;
        let coded = |selector: &[u8; 2]| {
            let component = frame.components.iter().position(|component| component.id == selector[0])?;
            Some(Coded { component, dc: usize::from(selector[1] >> 4 & 3), ac: usize::from(selector[1] & 3) })
        };
        let coded: Vec<Coded> = selectors.as_chunks().0.iter().map(coded).collect::<Option<_>>()?;
        let &[first, last, bits] = band.first_chunk()?;
        let band = match frame.progressive {
            true => Band { first: first.into(), last: last.into(), refines: bits >> 4 > 0, low_bit: bits & 15 },
            false => Band { first: 0, last: 63, refines: false, low_bit: 0 },
        };
        if band.last > 63 || band.first > band.last || coded.is_empty() {
            return None;
        }
        for &Coded { component, .. } in &coded {
            frame.components[component].unsent[band.first..=band.last].fill(band.low_bit);
        }
        Scan { huffman: &self.huffman, steps: self.steps, frame, band, end_of_band: 0, bits: Bits::new(data) }
            .walk(&coded, self.restart_interval)
    }
}

impl Frame {
    fn read(segment: &[u8], progressive: bool) -> Option<Self> {
        let (&[precision, h0, h1, w0, w1, count], rest) = segment.split_first_chunk()?;
        let size = [u16::from_be_bytes([w0, w1]), u16::from_be_bytes([h0, h1])].map(usize::from);
        let described = rest.as_chunks::<3>().0.get(..usize::from(count))?;
        let sampling = |both: u8| [usize::from(both >> 4), usize::from(both & 15)];
        let most = |axis: usize| described.iter().map(|component| sampling(component[1])[axis]).max();
        let most = [most(0)?, most(1)?];
        let valid = described.iter().all(|component| sampling(component[1]).iter().all(|n| (1..=4).contains(n)));
        if precision != 8 || !valid || size.contains(&0) {
            return None;
        }
        let mcus = [0, 1].map(|axis| size[axis].div_ceil(8 * most[axis]));
        let component = |&[id, both, quantisation]: &[u8; 3]| {
            let sampling = sampling(both);
            let blocks = [0, 1].map(|axis| (size[axis] * sampling[axis]).div_ceil(8 * most[axis]));
            let stored = if progressive { mcus[0] * sampling[0] * mcus[1] * sampling[1] } else { 0 };
            let quantisation = usize::from(quantisation & 3);
            Component { id, sampling, blocks, quantisation, nonzero: vec![0; stored], unsent: [255; 64] }
        };
        Some(Self { progressive, components: described.iter().map(component).collect(), mcus })
    }

    /// What no scan has brought.
    fn missing(&self) -> Option<String> {
        let missing = self.components.iter().any(|component| component.unsent.iter().any(|&bits| bits > 0));
        missing.then(|| "some of its scans are missing".to_owned())
    }
}

/// The walk through the data of a scan.
struct Scan<'a> {
    huffman: &'a [[Option<HuffmanTable>; 4]; 2],
    steps: [i64; 4],
    frame: &'a mut Frame,
    band: Band,
    /// Blocks to come in which the band has nothing new.
    end_of_band: u32,
    bits: Bits<'a>,
}

impl Scan<'_> {
    fn walk(mut self, coded: &[Coded], restart_interval: usize) -> Option<ControlFlow<String, usize>> {
        // A component alone comes block by block, several come MCU by MCU.
        let (units, alone) = match coded {
            [one] => (self.frame.components[one.component].blocks, true),
            _ => (self.frame.mcus, false),
        };
        let needs = [self.band.first == 0 && !self.band.refines, self.band.last > 0];
        let has = |class: usize, table: usize| !needs[class] || self.huffman[class][table].is_some();
        if !coded.iter().all(|coded| has(0, coded.dc) && has(1, coded.ac)) {
            return None;
        }
        let mut brightness = vec![0; coded.len()];
        let count = units[0] * units[1];
        for unit in 0..count {
            if restart_interval > 0 && unit > 0 && unit % restart_interval == 0 {
                brightness.fill(0);
                self.end_of_band = 0;
                if !self.bits.restart() {
                    return Some(ControlFlow::Break(self.fault(Fault::Impossible, unit, count)));
                }
            }
            let (column, row) = (unit % units[0], unit / units[0]);
            for (coded, brightness) in coded.iter().zip(&mut brightness) {
                let [across, down] = if alone { [1, 1] } else { self.frame.components[coded.component].sampling };
                for block in 0..across * down {
                    let place = (column * across + block % across, row * down + block / across);
                    if let Err(fault) = self.block(*coded, place, brightness) {
                        return Some(ControlFlow::Break(self.fault(fault, unit, count)));
                    }
                }
            }
        }
        Some(match !self.bits.are_at_their_end() || self.end_of_band > 0 {
            true => ControlFlow::Break("its data do not match its size: bytes are missing or were changed".to_owned()),
            false => ControlFlow::Continue(self.bits.position - self.bits.unread()),
        })
    }

    fn fault(&self, fault: Fault, unit: usize, count: usize) -> String {
        let share = 100 * unit / count;
        match fault {
            Fault::Ended => format!("it is truncated, its data end after {share} % of the picture"),
            Fault::Impossible => format!("its data are damaged, at the latest after {share} % of the picture"),
        }
    }

    fn block(&mut self, coded: Coded, place: (usize, usize), brightness: &mut i64) -> Result<(), Fault> {
        let band = self.band;
        if band.first == 0 && band.refines {
            self.bits.take(1)?;
        } else if band.first == 0 {
            self.dc(coded, brightness)?;
        }
        if band.last == 0 {
            return Ok(());
        }
        let Some(table) = &self.huffman[1][coded.ac] else { return Err(Fault::Impossible) };
        if !self.frame.progressive {
            return sequential(table, &mut self.bits);
        }
        let component = &mut self.frame.components[coded.component];
        let stride = self.frame.mcus[0] * component.sampling[0];
        let nonzero = &mut component.nonzero[place.1 * stride + place.0];
        match band.refines {
            false => first_bits(table, &mut self.bits, band, &mut self.end_of_band, nonzero),
            true => further_bits(table, &mut self.bits, band, &mut self.end_of_band, nonzero),
        }
    }

    /// The mean brightness of a block, as a difference from the one before. It cannot leave the range of the samples by far.
    fn dc(&mut self, coded: Coded, brightness: &mut i64) -> Result<(), Fault> {
        const LIMIT: i64 = 1100;
        let Some(table) = &self.huffman[0][coded.dc] else { return Err(Fault::Impossible) };
        let size = self.bits.symbol(table)?;
        if size > LARGEST_DC {
            return Err(Fault::Impossible);
        }
        let bits = i64::from(self.bits.take(u32::from(size))?);
        let positive = size > 0 && bits >> (size - 1) == 1;
        *brightness += if positive || size == 0 { bits } else { bits - (1 << size) + 1 };
        let step = self.steps[self.frame.components[coded.component].quantisation].max(1);
        let value = (*brightness << self.band.low_bit).abs() * step;
        if value > LIMIT + 2 * step { Err(Fault::Impossible) } else { Ok(()) }
    }
}

/// The coefficients of a block that are sent at once.
fn sequential(table: &HuffmanTable, bits: &mut Bits) -> Result<(), Fault> {
    let mut place = 1;
    while place < 64 {
        let symbol = bits.symbol(table)?;
        let (run, size) = (usize::from(symbol >> 4), u32::from(symbol & 15));
        place += run + 1;
        match size {
            0 if run < 15 => return Ok(()),
            0 => (),
            1..=LARGEST_AC => drop(bits.take(size)?),
            _ => return Err(Fault::Impossible),
        }
    }
    if place > 64 { Err(Fault::Impossible) } else { Ok(()) }
}

/// The first bits of the coefficients of a band.
fn first_bits(
    table: &HuffmanTable,
    bits: &mut Bits,
    band: Band,
    end_of_band: &mut u32,
    nonzero: &mut u64,
) -> Result<(), Fault> {
    if *end_of_band > 0 {
        *end_of_band -= 1;
        return Ok(());
    }
    let mut place = band.first;
    while place <= band.last {
        let symbol = bits.symbol(table)?;
        let (run, size) = (usize::from(symbol >> 4), u32::from(symbol & 15));
        place += run;
        if size == 0 && run < 15 {
            *end_of_band = (1 << run) - 1 + bits.take(run as u32)?;
            return Ok(());
        }
        if size > 0 {
            if place > band.last || size > LARGEST_AC {
                return Err(Fault::Impossible);
            }
            bits.take(size)?;
            *nonzero |= 1 << place;
        }
        place += 1;
    }
    Ok(())
}

/// One more bit of the coefficients of a band that are not zero, and those that become so.
fn further_bits(
    table: &HuffmanTable,
    bits: &mut Bits,
    band: Band,
    end_of_band: &mut u32,
    nonzero: &mut u64,
) -> Result<(), Fault> {
    let mut place = band.first;
    while place <= band.last && *end_of_band == 0 {
        let symbol = bits.symbol(table)?;
        let (mut run, size) = (u32::from(symbol >> 4), symbol & 15);
        match size {
            0 if run < 15 => {
                *end_of_band = (1 << run) + bits.take(run)?;
                break;
            }
            0 => (),
            1 => drop(bits.take(1)?),
            _ => return Err(Fault::Impossible),
        }
        while place <= band.last {
            if *nonzero >> place & 1 == 1 {
                bits.take(1)?;
            } else if run == 0 {
                break;
            } else {
                run -= 1;
            }
            place += 1;
        }
        if size == 1 {
            if place > band.last {
                return Err(Fault::Impossible);
            }
            *nonzero |= 1 << place;
        }
        place += 1;
    }
    if *end_of_band > 0 {
        let known = (place..=band.last).filter(|place| *nonzero >> place & 1 == 1).count();
        (0..known).try_for_each(|_| bits.take(1).map(drop))?;
        *end_of_band -= 1;
    }
    Ok(())
}

/// The bits of coded data: `FF 00` is the byte `FF`, any other `FF` the start of a marker.
struct Bits<'a> {
    data: &'a [u8],
    position: usize,
    /// The next bits, from the highest on.
    window: u64,
    count: u32,
}

impl<'a> Bits<'a> {
    fn new(data: &'a [u8]) -> Self {
        Self { data, position: 0, window: 0, count: 0 }
    }

    #[inline]
    fn fill(&mut self) {
        while self.count <= 56 {
            let Some(&byte) = self.data.get(self.position) else { return };
            self.position += match (byte, self.data.get(self.position + 1)) {
                (0xFF, Some(0)) => 2,
                (0xFF, _) => return,
                _ => 1,
            };
            self.window |= u64::from(byte) << (56 - self.count);
            self.count += 8;
        }
    }

    #[inline]
    fn take(&mut self, count: u32) -> Result<u32, Fault> {
        if count == 0 {
            return Ok(0);
        }
        if self.count < count {
            self.fill();
        }
        let bits = (self.window >> (64 - count)) as u32;
        self.skip(count).map(|()| bits)
    }

    #[inline]
    fn skip(&mut self, count: u32) -> Result<(), Fault> {
        if self.count < count {
            return Err(Fault::Ended);
        }
        self.window <<= count;
        self.count -= count;
        Ok(())
    }

    #[inline]
    fn symbol(&mut self, table: &HuffmanTable) -> Result<u8, Fault> {
        if self.count < 16 {
            self.fill();
        }
        let (length, symbol) = table.0[(self.window >> 48) as usize];
        match length {
            0 if self.count < 16 => Err(Fault::Ended),
            0 => Err(Fault::Impossible),
            _ => self.skip(length.into()).map(|()| symbol),
        }
    }

    /// Whole bytes that were fetched but not used.
    fn unread(&self) -> usize {
        self.count as usize / 8
    }

    /// True if nothing but padding stands before the next marker: bits that are all 1 (or, from some writers, 0) up to the end
    /// of the byte, and a few bytes that are all the same. Data that were changed and still have the right count of blocks
    /// rarely end so.
    fn are_at_their_end(&self) -> bool {
        let bits = self.count % 8;
        let padding = self.window >> (63 - bits) >> 1;
        let fetched = (0..self.count / 8).map(|byte| (self.window << bits >> (56 - 8 * byte)) as u8);
        let rest = &self.data[self.position..];
        let is_marker = |pair: &[u8]| pair[0] == 0xFF && !matches!(pair[1], 0 | 0xFF);
        let rest = &rest[..rest.windows(2).position(is_marker).unwrap_or(rest.len())];
        let mut left = fetched.chain(rest.iter().copied());
        let first = left.next();
        (padding == 0 || padding + 1 == 1 << bits)
            && self.unread() + rest.len() <= MOST_LEFT_OVER
            && left.all(|byte| Some(byte) == first)
    }

    /// Goes behind the restart marker that has to stand here.
    fn restart(&mut self) -> bool {
        let here = self.are_at_their_end();
        let rest = &self.data[self.position..];
        let Some(marker) = rest.windows(2).position(|pair| pair[0] == 0xFF && !matches!(pair[1], 0 | 0xFF)) else {
            return false;
        };
        let is_restart = matches!(rest[marker + 1], 0xD0..=0xD7);
        self.position += marker + 2;
        (self.window, self.count) = (0, 0);
        here && is_restart
    }
}
