//! Chooses the channels of an EXR file that make a picture. A file has parts, and a part has layers: channels whose
//! names begin alike, such as `Diffuse.R`, `Diffuse.G` and `Diffuse.B`.

use exr::meta::header::Header;
use exr::prelude::Compression;
use indexmap::IndexMap;

/// Largest number of layers that a message lists.
const MOST_LISTED: usize = 20;

/// The channels that make a picture.
#[derive(Clone, Debug)]
pub(super) struct Choice {
    /// The number of the part in the file.
    pub part: usize,
    /// The places of one or three channels in the list of the part.
    pub channels: Vec<usize>,
    /// The place of the channel with alpha.
    pub alpha: Option<usize>,
    pub is_depth: bool,
}

/// A layer of a part.
struct Layer {
    part: usize,
    /// The names of the part and of the layer, with a point between them. Empty for a layer without names.
    name: String,
    /// Whether the channels have their plain names, such as R.
    is_plain: bool,
    /// The last part of each channel's name, and its place.
    channels: Vec<(String, usize)>,
}

impl Choice {
    /// Returns the channels of the layer `wanted`, or those of the only layer with R, G and B if there is no wish. Says
    /// in `notes` which layer of several was taken.
    ///
    /// # Errors
    /// A message that lists the layers.
    pub fn of(headers: &[Header], wanted: Option<&str>, notes: &mut Vec<String>) -> Result<Self, String> {
        let layers: Vec<Layer> = headers.iter().enumerate().flat_map(|(part, header)| layers(part, header)).collect();
        let listed = listed(&layers);
        let (choice, name) = match wanted {
            Some(wanted) => {
                named(&layers, wanted).ok_or_else(|| format!("an EXR without the layer {wanted}; {listed}"))?
            }
            None => automatic(&layers).ok_or_else(|| {
                format!("an EXR in which several layers, or none, can be the picture; choose one by --layer: {listed}")
            })?,
        };
        let compression = headers[choice.part].compression;
        if let Compression::DWAA(_) | Compression::DWAB(_) = compression {
            return Err(format!("an EXR with the compression {compression}; save it with ZIP or PIZ; {listed}"));
        }
        let count = choice.channels.len() + usize::from(choice.alpha.is_some());
        if wanted.is_none() && layers.iter().map(|layer| layer.channels.len()).sum::<usize>() > count {
            notes.push(format!("{name} is taken; --layer takes another one: {listed}"));
        }
        Ok(choice)
    }
}

/// Returns the layers of a part.
fn layers(part: usize, header: &Header) -> Vec<Layer> {
    let of_part = header.own_attributes.layer_name.as_ref().map(ToString::to_string).unwrap_or_default();
    let mut groups: IndexMap<String, Vec<(String, usize)>> = IndexMap::new();
    for (at, channel) in header.channels.list.iter().enumerate() {
        let full = channel.name.to_string();
        let (prefix, last) = full.rsplit_once('.').unwrap_or(("", &full));
        groups.entry(prefix.to_owned()).or_default().push((last.to_owned(), at));
    }
    let layer = |(prefix, channels): (String, Vec<_>)| {
        let name = match (of_part.is_empty() || prefix.starts_with(&of_part), prefix.is_empty()) {
            (false, false) => format!("{of_part}.{prefix}"),
            (_, true) => of_part.clone(),
            _ => prefix.clone(),
        };
        Layer { part, name, is_plain: prefix.is_empty(), channels }
    };
    groups.into_iter().map(layer).collect()
}

impl Layer {
    /// Returns the picture of the layer: three colours, three coordinates, or a single channel.
    fn choice(&self) -> Option<Choice> {
        let place = |name: &str| {
            let channel = self.channels.iter().find(|(channel, _)| channel.eq_ignore_ascii_case(name));
            channel.map(|&(_, place)| place)
        };
        let all = |names: [&str; 3]| names.map(place).into_iter().collect::<Option<Vec<_>>>();
        let alpha = place("A");
        let others: Vec<_> = self.channels.iter().filter(|(_, place)| Some(*place) != alpha).collect();
        let (channels, is_depth) = match (all(["R", "G", "B"]).or_else(|| all(["X", "Y", "Z"])), &others[..]) {
            (Some(channels), _) => (channels, false),
            (None, [(name, only)]) => (vec![*only], name == "Z"),
            _ => return None,
        };
        Some(Choice { part: self.part, channels, alpha, is_depth })
    }

    fn is_colour(&self) -> bool {
        ["R", "G", "B"].iter().all(|name| self.channels.iter().any(|(channel, _)| channel.eq_ignore_ascii_case(name)))
    }

    fn shown(&self) -> String {
        if self.name.is_empty() { "the layer without a name".to_owned() } else { self.name.clone() }
    }
}

/// Returns the layer or the channel of this name.
fn named(layers: &[Layer], wanted: &str) -> Option<(Choice, String)> {
    let of_layer = layers.iter().find(|layer| layer.name == wanted).and_then(Layer::choice);
    let of_channel = || {
        layers.iter().find_map(|layer| {
            let full =
                |name: &str| if layer.name.is_empty() { name.to_owned() } else { format!("{}.{name}", layer.name) };
            let (name, place) = layer.channels.iter().find(|(name, _)| full(name) == wanted)?;
            Some(Choice { part: layer.part, channels: vec![*place], alpha: None, is_depth: name == "Z" })
        })
    };
    of_layer.or_else(of_channel).map(|choice| (choice, wanted.to_owned()))
}

/// Returns the only layer with colours, the one whose channels have plain names, or the one named Combined. Without
/// colours, returns the only layer that makes a picture.
fn automatic(layers: &[Layer]) -> Option<(Choice, String)> {
    fn only<'a>(mut layers: impl Iterator<Item = &'a Layer>) -> Option<&'a Layer> {
        layers.next().filter(|_| layers.next().is_none())
    }
    let colours = || layers.iter().filter(|layer| layer.is_colour());
    let is_combined = |layer: &&Layer| layer.name.rsplit('.').next() == Some("Combined");
    let found = if colours().next().is_none() {
        only(layers.iter().filter(|layer| layer.choice().is_some()))
    } else {
        let plain = || only(colours().filter(|layer| layer.is_plain));
        only(colours()).or_else(plain).or_else(|| only(colours().filter(is_combined)))
    };
    found.and_then(|layer| Some((layer.choice()?, layer.shown())))
}

/// Returns the text that lists all layers with their channels.
fn listed(layers: &[Layer]) -> String {
    let one = |layer: &Layer| {
        let names: Vec<_> = layer.channels.iter().map(|(name, _)| name.as_str()).take(MOST_LISTED).collect();
        format!("{} ({})", layer.shown(), names.join(", "))
    };
    let more = layers.len().saturating_sub(MOST_LISTED);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    let text = layers.iter().take(MOST_LISTED).map(one).collect::<Vec<_>>().join(", ");
    format!("it has {}{more}", crate::terminal::escape_lines(&text.replace('\n', " ")))
}
