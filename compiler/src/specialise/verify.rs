//! What holds of a specialised graph: what all engines rely on. Asked after each one is made in debug builds.

use crate::kernels::BodyForms;
use crate::ops::Op;
use crate::ops::verify::masks;
use crate::storage::Source;

use super::{
    Context, EpochId, EpochKind, Guard, Instance, InstanceId, InstanceKind, Specialised, Subject,
    Turns,
};

/// Whether all that instances name exists and comes before them; whether each word is a constant that
/// stands where it says, a uniform word, a field of the point or of a turn round the instance, or what an
/// instance writes that is demanded before it is read; whether no slot is written by two; whether
/// bodies take and yield as many words as they are given, and guards are masks.
///
/// # Errors
/// What is wrong, and where.
pub fn verify(graph: &Specialised) -> Result<(), String> {
    let owners = Owners::of(graph)?;
    let check = Check { graph, owners };
    check.epochs()?;
    for (id, instance) in &graph.instances {
        check.instance(id, instance).map_err(|what| format!("{}: {what}", instance.name))?;
    }
    match graph.instances.last() {
        Some((_, root)) if root.outputs == 5 => Ok(()),
        _ => Err("the last instance is no root".to_owned()),
    }
}

/// Who writes each slot.
struct Owners(Vec<Option<Owner>>);

#[derive(Clone, Copy, PartialEq)]
enum Owner {
    Field,
    Turn(EpochId),
    Instance(InstanceId),
}

impl Owners {
    fn of(graph: &Specialised) -> Result<Self, String> {
        let mut owners = Self(vec![None; graph.slots as usize]);
        for &(field, first) in &graph.fields {
            owners.own(first, field.value_type().width() as u32, Owner::Field)?;
        }
        for (id, epoch) in &graph.epochs.0 {
            if let EpochKind::Loop { iterated, fields, .. } = epoch.kind {
                owners.own(fields, iterated.words() as u32, Owner::Turn(id))?;
            }
        }
        for (id, instance) in &graph.instances {
            owners.own(instance.output, instance.outputs, Owner::Instance(id))?;
        }
        Ok(owners)
    }

    fn own(&mut self, first: u32, count: u32, owner: Owner) -> Result<(), String> {
        for slot in first..first + count {
            match self.0.get_mut(slot as usize) {
                None => return Err(format!("slot {slot} is written and is none")),
                Some(Some(_)) => return Err(format!("slot {slot} is written by two")),
                Some(of) => *of = Some(owner),
            }
        }
        Ok(())
    }
}

struct Check<'a> {
    graph: &'a Specialised,
    owners: Owners,
}

impl Check<'_> {
    fn epochs(&self) -> Result<(), String> {
        let all = &self.graph.epochs.0;
        for (id, epoch) in all {
            if id != EpochId::POINT && epoch.parent >= id {
                return Err(format!("{id} does not come after the one outside"));
            }
            let is_loop = |of: &EpochId| matches!(all[*of].kind, EpochKind::Loop { .. });
            if !epoch.loops.iter().all(|of| all.is_valid(*of) && *of <= id && is_loop(of)) {
                return Err(format!("{id} stands in loops that are none"));
            }
        }
        Ok(())
    }

    fn instance(&self, id: InstanceId, instance: &Instance) -> Result<(), String> {
        if !self.graph.epochs.0.is_valid(instance.epoch) {
            return Err(format!("it belongs to {}, which is none", instance.epoch));
        }
        let mut demanded = Vec::new();
        for demand in &instance.demands {
            if demand.source >= id {
                return Err(format!("it demands {}, which does not come before it", demand.source));
            }
            if let Some(guard) = &demand.guard {
                self.guard(instance, guard, &demanded)?;
            }
            demanded.push(demand.source);
        }
        self.words(instance, &instance.words, &demanded)?;
        match &instance.kind {
            InstanceKind::Plain(code) => {
                takes(code, &instance.words)?;
                if code.outputs != instance.outputs as usize {
                    return Err("its body yields another number of words".to_owned());
                }
                Ok(())
            }
            InstanceKind::Request { effect, context, loops, subject, .. } => {
                if effect.answer_words() != instance.outputs as usize {
                    return Err("it is answered with another number of words".to_owned());
                }
                self.context(instance, context, &demanded)?;
                self.loops(instance, loops)?;
                self.subject(instance, *subject)
            }
            InstanceKind::Loop { .. } => self.turns(id, instance, demanded),
        }
    }

    fn guard(
        &self,
        instance: &Instance,
        guard: &Guard,
        demanded: &[InstanceId],
    ) -> Result<(), String> {
        self.words(instance, &guard.words, demanded)?;
        takes(&guard.code, &guard.words)?;
        let recorded = guard.code.recorded();
        match recorded.outputs.as_slice() {
            [mask] if masks(&recorded.ops)[*mask as usize] => Ok(()),
            _ => Err("a guard is no mask".to_owned()),
        }
    }

    /// Whether words are there once these were demanded.
    fn words(
        &self,
        instance: &Instance,
        words: &[Source],
        demanded: &[InstanceId],
    ) -> Result<(), String> {
        let uniforms = self.graph.uniforms.values();
        for word in words {
            let is_there = match *word {
                Source::Constant { at, bits } => uniforms.get(at as usize) == Some(&bits),
                Source::Uniform(at) => (at as usize) < uniforms.len(),
                Source::Slot(slot) => match self.owners.0.get(slot as usize).copied().flatten() {
                    None => false,
                    Some(Owner::Field) => true,
                    Some(Owner::Turn(of)) => self.graph.epochs.within(instance.epoch, of),
                    Some(Owner::Instance(of)) => demanded.contains(&of),
                },
            };
            if !is_there {
                return Err(format!("it reads {word:?} before it is there"));
            }
        }
        Ok(())
    }

    fn context(
        &self,
        instance: &Instance,
        context: &Context,
        demanded: &[InstanceId],
    ) -> Result<(), String> {
        for (field, words) in context {
            if words.len() != field.value_type().width() {
                return Err(format!("{} has another number of words", field.name()));
            }
            self.words(instance, words, demanded)?;
        }
        Ok(())
    }

    fn loops(&self, instance: &Instance, loops: &[EpochId]) -> Result<(), String> {
        match self.graph.epochs.0[instance.epoch].loops == loops {
            true => Ok(()),
            false => Err("it stands in other loops than it says".to_owned()),
        }
    }

    fn subject(&self, instance: &Instance, subject: Subject<EpochId>) -> Result<(), String> {
        let is_there = match subject {
            Subject::Point => true,
            Subject::Texture(texture, _) => self.graph.textures.is_valid(texture),
            Subject::Light { of, table } => {
                let lights = self.graph.epochs.innermost_lights(instance.epoch);
                lights.is_some_and(|(inside, list)| {
                    let table = self.graph.tables.get(table);
                    inside == of && table.is_some_and(|table| table.list == list)
                })
            }
        };
        if is_there { Ok(()) } else { Err(format!("it asks about {subject:?}, which is none")) }
    }

    fn turns(
        &self,
        id: InstanceId,
        instance: &Instance,
        mut demanded: Vec<InstanceId>,
    ) -> Result<(), String> {
        let InstanceKind::Loop { epoch, turns, value_type, fields, body, words, context, .. } =
            &instance.kind
        else {
            return Ok(());
        };
        self.context(instance, context, &demanded)?;
        if let Turns::Samples { count, loops, .. } = turns {
            self.words(instance, &[*count], &demanded)?;
            self.loops(instance, loops)?;
        }
        let opened = self.graph.epochs.0.get(*epoch);
        let opened = opened.filter(|of| of.parent == instance.epoch);
        let list = match opened.map(|of| &of.kind) {
            Some(EpochKind::Loop { fields: of, list, .. }) if of == fields => *list,
            _ => return Err("its turns are in an epoch that it did not open".to_owned()),
        };
        let lights = match turns {
            Turns::Lights { list } => Some(*list),
            Turns::Samples { .. } => None,
        };
        if lights != list || lights.is_some_and(|of| !self.graph.light_lists.is_valid(of)) {
            return Err("it runs over lights that its epoch does not".to_owned());
        }
        let width = value_type.width();
        if words.len() != width || instance.outputs as usize != width {
            return Err("its value has another number of words".to_owned());
        }
        if let Some(body) = body {
            if *body >= id {
                return Err("its body does not come before it".to_owned());
            }
            demanded.push(*body);
        }
        let inside = Instance { epoch: *epoch, ..instance.clone() };
        self.words(&inside, words, &demanded)
    }
}

/// Whether a body finds all the words it reads.
fn takes(code: &BodyForms, words: &[Source]) -> Result<(), String> {
    let ops = code.recorded().ops.iter();
    let most = ops.filter_map(|op| match op {
        Op::Load(word) => Some(*word as usize + 1),
        _ => None,
    });
    match most.max().unwrap_or(0) <= words.len() {
        true => Ok(()),
        false => Err("a body reads more words than it is given".to_owned()),
    }
}
