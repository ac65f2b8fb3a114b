//! The lines of a file that a finding shows, as a terminal can show them: what cannot be seen is escaped, and of a line
//! that is too long the part round the place is shown.

use std::ops::Range;

use miette::{MietteError, MietteSpanContents, SourceCode, SourceSpan, SpanContents};
use phenomenon_compiler::diagnostics::{Finding, Place, SourceFile};
use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

use crate::terminal::{self, Look};

/// Most places shown in the excerpt of one finding.
const MOST_MARKS: usize = 8;
/// Most lines a place may span to be marked whole; of longer ones the first line is.
const MOST_LINES: usize = 8;
/// Most columns of a line that goes to no terminal.
const LONGEST_LINE: usize = 400;
/// Columns from one stop of a tab to the next.
const TAB: usize = 4;
/// Characters by which an excerpt may be moved to the right with the lines round it: to find where those go on they
/// are read from their starts.
const FARTHEST_NEIGHBOUR: usize = 4096;

/// Some lines of a file as text of its own, and the places marked in it.
#[derive(Debug)]
pub struct Excerpt {
    name: String,
    text: String,
    lines: Vec<Line>,
    /// What is marked; the finding's own place first.
    pub marks: Vec<Mark>,
    /// Positions in the finding's `related` that have no mark with their message.
    pub unmarked: Vec<usize>,
}

#[derive(Debug)]
struct Line {
    /// In the file, from 1.
    number: usize,
    /// Where it stands in the text.
    shown: Range<usize>,
}

/// A place that is marked.
#[derive(Debug)]
pub struct Mark {
    /// Where it stands in the text.
    pub shown: Range<usize>,
    /// What is said of it.
    pub label: Option<String>,
    /// Line and column in the file, from 1.
    at: (usize, usize),
}

/// A place to mark: bytes of the file, and the position in `related`, none for the finding's own.
struct Wanted<'f> {
    bytes: Range<usize>,
    lines: Range<usize>,
    related: Option<usize>,
    place: &'f Place,
}

impl Excerpt {
    /// The lines round the places of a finding that are in its own file; none where the file has no text.
    pub fn of(finding: &Finding, look: &Look) -> Option<Self> {
        let file = &*finding.place.file;
        if file.text.is_empty() {
            return None;
        }
        let mut unmarked = Vec::new();
        let mut wanted = vec![Wanted::new(&finding.place, None)];
        for (at, related) in finding.related.iter().enumerate() {
            if related.place.file != finding.place.file {
                unmarked.push(at);
            } else if wanted.len() < MOST_MARKS {
                wanted.push(Wanted::new(&related.place, Some(at)));
            }
        }
        let last = wanted.iter().map(|it| it.lines.end).max().unwrap_or(1);
        let gutter = wanted.iter().filter(|it| it.lines.len() > 1).count();
        // miette puts the number, a rule and three spaces before a line, and arrows of places that span several.
        let before = last.to_string().len() + 4 + if gutter > 0 { gutter + 3 } else { 0 };
        // Where no width is known, lines are kept as long as they can be read.
        let room =
            if look.wraps { look.width.saturating_sub(before).max(12) } else { LONGEST_LINE };
        let mut excerpt = Self {
            name: terminal::shown(&file.name, look).into_owned(),
            text: String::new(),
            lines: Vec::new(),
            marks: Vec::new(),
            unmarked,
        };
        let marked = excerpt.draw(file, &wanted, room, look);
        for (wanted, shown) in wanted.iter().zip(marked) {
            let label = wanted.related.map(|at| finding.related[at].message.as_str());
            excerpt.mark(wanted, shown, label, room, look);
        }
        excerpt.unmarked.sort_unstable();
        Some(excerpt)
    }

    /// Writes the lines of all places; where each place is in the text, none where it is cut off.
    fn draw(
        &mut self,
        file: &SourceFile,
        wanted: &[Wanted<'_>],
        room: usize,
        look: &Look,
    ) -> Vec<Option<Range<usize>>> {
        // The first place that has a line decides which part of it is shown.
        let mut starts: std::collections::BTreeMap<usize, usize> =
            std::collections::BTreeMap::new();
        for it in wanted {
            let start = it.window(file, room, look);
            for number in it.lines.clone() {
                starts.entry(number).or_insert(start);
            }
        }
        for it in wanted {
            let start = starts[&it.lines.start];
            let neighbours = [it.lines.start.saturating_sub(1), it.lines.end];
            for number in neighbours.into_iter().filter(|number| is_line(file, *number)) {
                let start = if start > FARTHEST_NEIGHBOUR { 0 } else { start };
                starts.entry(number).or_insert(start);
            }
        }
        let mut ends: Vec<[Option<usize>; 2]> = vec![[None; 2]; wanted.len()];
        for (&number, &start) in &starts {
            let from = self.text.len();
            let line = file.line(number);
            let mut drawn = Drawn::new(start, room, look);
            drawn.line(&file.text, line, wanted.iter().map(|it| it.bytes.clone()), &mut ends, from);
            self.text.push_str(&drawn.text);
            self.lines.push(Line { number, shown: from..self.text.len() });
            self.text.push('\n');
        }
        self.text.pop();
        ends.into_iter().map(|[start, end]| Some(start?..end?)).collect()
    }

    /// Marks a place; what is said of it goes below the excerpt where it has no room beside the place.
    fn mark(
        &mut self,
        wanted: &Wanted<'_>,
        shown: Option<Range<usize>>,
        label: Option<&str>,
        room: usize,
        look: &Look,
    ) {
        let Some(shown) = shown else {
            self.unmarked.extend(wanted.related);
            return;
        };
        let label = label.map(|label| terminal::shown(label, look).into_owned());
        let line = self.lines.iter().find(|line| line.shown.end >= shown.end);
        let line = line.map_or(shown.start, |line| line.shown.start.min(shown.start));
        let (column, length) =
            (self.text[line..shown.start].width(), self.text[shown.clone()].width());
        // Below the middle of the place stands `╰── ` and then the label.
        let has_room = |label: &String| column + length / 2 + 4 + label.width() <= room;
        let label = match label {
            Some(label) if has_room(&label) => Some(label),
            Some(_) => {
                self.unmarked.extend(wanted.related);
                None
            }
            None => None,
        };
        self.marks.push(Mark { shown, label, at: wanted.place.line_column() });
    }
}

impl<'f> Wanted<'f> {
    fn new(place: &'f Place, related: Option<usize>) -> Self {
        let text = &place.file.text;
        let start = text.floor_char_boundary(place.start);
        let end = text.floor_char_boundary(place.end).max(start);
        let (first, _) = place.file.line_column(start);
        let (last, _) = place.file.line_column(end.saturating_sub(1).max(start));
        if last - first < MOST_LINES {
            return Self { bytes: start..end, lines: first..last + 1, related, place };
        }
        let end = place.file.line(first).end.max(start);
        Self { bytes: start..end, lines: first..first + 1, related, place }
    }

    /// The first character of the line that is shown, so that the place is.
    fn window(&self, file: &SourceFile, room: usize, look: &Look) -> usize {
        let line = file.line(self.lines.start);
        if self.lines.len() > 1 {
            return 0;
        }
        let sees = |start: usize| {
            let mut ends = [[None; 2]];
            let mut drawn = Drawn::new(start, room, look);
            let places = std::iter::once(self.bytes.clone());
            drawn.line(&file.text, line.clone(), places, &mut ends, 0);
            ends[0] != [None; 2] && !drawn.cut_within
        };
        let column = file.line_column(self.bytes.start).1 - 1;
        let end = file.line_column(self.bytes.end).1 - 1;
        // From the start, or with some of what is before it, or, where that is wide, from the place on.
        if column.max(end) <= 4 * room && sees(0) {
            return 0;
        }
        // A place that is longer than the line has room is seen to begin.
        if column <= room / 3 {
            return 0;
        }
        let context = column - room / 3;
        if sees(context) { context } else { column }
    }
}

/// Whether a file has that line; an empty one after its last line break is none.
fn is_line(file: &SourceFile, number: usize) -> bool {
    let (last, column) = file.line_column(file.text.len());
    (1..=last).contains(&number) && !(number == last && column == 1)
}

/// A line as it is shown.
struct Drawn<'l> {
    text: String,
    /// The first character that is shown.
    start: usize,
    room: usize,
    width: usize,
    /// Whether the first place goes on past what is shown.
    cut_within: bool,
    look: &'l Look,
}

impl<'l> Drawn<'l> {
    fn new(start: usize, room: usize, look: &'l Look) -> Self {
        Self { text: String::new(), start, room, width: 0, cut_within: false, look }
    }

    /// Draws a line, and puts into `ends` where the places on it are, `from` bytes further on.
    fn line(
        &mut self,
        text: &str,
        line: Range<usize>,
        places: impl Iterator<Item = Range<usize>> + Clone,
        ends: &mut [[Option<usize>; 2]],
        from: usize,
    ) {
        if self.start > 0 {
            self.cut();
        }
        let (mut first, mut last) = (None, line.start);
        let mut is_cut = false;
        let at = skipped(&text[line.clone()], self.start);
        for (at, character) in text[line.start + at..line.end]
            .char_indices()
            .map(|(byte, it)| (line.start + at + byte, it))
        {
            let before = self.text.len();
            // One column stays for the sign that something is cut.
            let is_last = at + character.len_utf8() == line.end;
            if !self.character(character, if is_last { self.room } else { self.room - self.sign() })
            {
                is_cut = true;
                break;
            }
            first.get_or_insert(at);
            last = at + character.len_utf8();
            for (place, end) in places.clone().zip(ends.iter_mut()) {
                if place.start == at {
                    end[0] = Some(from + before);
                }
                if place.start < last && last <= place.end {
                    end[1] = Some(from + self.text.len());
                    // A place that began before what is shown.
                    end[0] = end[0].or(Some(from + before));
                }
            }
        }
        for (index, (place, end)) in places.zip(ends.iter_mut()).enumerate() {
            // A place of no width, or one at the end of the line.
            let here = place.start >= first.unwrap_or(line.start) && place.start <= last;
            if here && (!is_cut || place.start < last) && end[0].is_none() {
                end[0] = Some(from + self.text.len());
            }
            if here && end[1].is_none() {
                end[1] = end[0];
            }
            if index == 0 && is_cut && place.end > last && place.start <= line.end {
                self.cut_within = true;
            }
        }
        if is_cut {
            self.cut();
        }
    }

    /// Draws a character where it fits into `room`, and is not the one too many of those that take none.
    fn character(&mut self, character: char, room: usize) -> bool {
        let before = self.text.len();
        if character == '\t' {
            let spaces = TAB - self.width % TAB;
            self.text.extend(std::iter::repeat_n(' ', spaces));
        } else {
            terminal::pushed(&mut self.text, character, self.look);
        }
        let drawn = &self.text[before..];
        let width: usize = drawn.chars().map(|it| it.width().unwrap_or(0)).sum();
        if self.width + width > room || self.text.len() > 16 * self.room {
            self.text.truncate(before);
            return false;
        }
        self.width += width;
        true
    }

    /// Width of the sign that something is cut.
    fn sign(&self) -> usize {
        if self.look.ascii { 3 } else { 1 }
    }

    fn cut(&mut self) {
        self.text.push_str(if self.look.ascii { "..." } else { "…" });
        self.width += self.sign();
    }
}

/// Bytes of the first `count` characters.
fn skipped(text: &str, count: usize) -> usize {
    text.char_indices().nth(count).map_or(text.len(), |(at, _)| at)
}

impl SourceCode for Excerpt {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let (start, end) = (span.offset(), span.offset() + span.len());
        let line_of = |byte: usize| {
            let holds = |line: &Line| line.shown.start <= byte && byte <= line.shown.end;
            self.lines.iter().position(holds).ok_or(MietteError::OutOfBounds)
        };
        let (first, last) = (line_of(start)?, line_of(end.saturating_sub(1).max(start))?);
        let contents = |bytes: Range<usize>, (line, column): (usize, usize), lines: usize| {
            let data = self.text.as_bytes().get(bytes.clone()).ok_or(MietteError::OutOfBounds)?;
            let span = SourceSpan::from((bytes.start, bytes.len()));
            let name = self.name.clone();
            Ok(MietteSpanContents::new_named(name, data, span, line - 1, column - 1, lines))
        };
        if (before, after) == (0, 0) {
            // Asked for the place alone, from which the heading takes line and column.
            let mark = self.marks.iter().find(|mark| mark.shown == (start..end));
            let at = mark.map_or((self.lines[first].number, 1), |mark| mark.at);
            return contents(start..end, at, 1).map(|it| Box::new(it) as _);
        }
        // Lines that follow one another in the file; others are told apart.
        let follows = |at: usize| self.lines[at - 1].number + 1 == self.lines[at].number;
        if !(first + 1..=last).all(follows) {
            return Err(MietteError::OutOfBounds);
        }
        let (mut from, mut to) = (first, last);
        while from > first.saturating_sub(before) && follows(from) {
            from -= 1;
        }
        while to < (last + after).min(self.lines.len() - 1) && follows(to + 1) {
            to += 1;
        }
        let bytes = self.lines[from].shown.start..self.lines[to].shown.end;
        contents(bytes, (self.lines[from].number, 1), to - from + 1).map(|it| Box::new(it) as _)
    }
}
