//! Reads and writes OpenEXR files by the crate `exr`.

use std::io::{self, Cursor, Write};

use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, MetaData, ReadChannels, ReadLayers,
    SmallVec, WritableImage, read,
};

use super::floats::Floats;
use super::{DEFLATE_GROWTH, check_pixels};

const WRONG: &str = "an EXR that has neither the channels R, G and B nor a single one";

/// Writes the picture with the channels R, G and B, or Y if it has one channel.
pub(super) fn write(floats: &Floats, mut out: impl Write) -> io::Result<()> {
    let names = if floats.channels == 3 { &["R", "G", "B"][..] } else { &["Y"] };
    let channels = names.iter().enumerate().map(|(at, &name)| {
        let samples = floats.values.iter().skip(at).step_by(floats.channels).copied().collect();
        AnyChannel::new(name, FlatSamples::F32(samples))
    });
    let channels = AnyChannels::sort(channels.collect::<SmallVec<_>>());
    let size = (floats.width, floats.height);
    let layer = Layer::new(size, LayerAttributes::default(), Encoding::SMALL_FAST_LOSSLESS, channels);
    let mut bytes = Cursor::new(Vec::new());
    Image::from_layer(layer).write().non_parallel().to_buffered(&mut bytes).map_err(io::Error::other)?;
    out.write_all(bytes.get_ref())
}

/// Returns the picture in the bytes of an EXR file: its first layer, with the channels R, G and B or with one channel.
pub(super) fn parse(bytes: &[u8]) -> Result<Floats, String> {
    let meta = MetaData::read_from_buffered(Cursor::new(bytes), false).map_err(|error| error.to_string())?;
    for header in &meta.headers {
        // A few bytes can announce a picture of any size, so the size is checked before memory is taken.
        let count = check_pixels(header.layer_size.0.checked_mul(header.layer_size.1))?;
        let announced = count.saturating_mul(header.channels.bytes_per_pixel);
        if announced > bytes.len().saturating_mul(DEFLATE_GROWTH) {
            return Err(format!("an EXR that announces {announced} bytes of pixels and cannot hold them"));
        }
    }
    let reader = read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer().all_attributes();
    let image = reader.non_parallel().from_buffered(Cursor::new(bytes)).map_err(|error| error.to_string())?;
    let (size, list) = (image.layer_data.size, &image.layer_data.channel_data.list);
    let named = |name| list.iter().find(|channel: &&AnyChannel<_>| channel.name.eq_case_insensitive(name));
    let channels: Vec<_> = match (named("R"), named("G"), named("B"), &list[..]) {
        (Some(red), Some(green), Some(blue), _) => vec![red, green, blue],
        (_, _, _, [only]) => vec![only],
        _ => return Err(WRONG.to_owned()),
    };
    let mut floats = Floats::zeros(size.0, size.1, channels.len())?;
    for (at, channel) in channels.iter().enumerate() {
        if channel.sample_data.len() != size.area() {
            return Err(WRONG.to_owned());
        }
        let places = floats.values.iter_mut().skip(at).step_by(channels.len());
        places.zip(channel.sample_data.values_as_f32()).for_each(|(place, value)| *place = value);
    }
    Ok(floats)
}
