//! Computes SHA-256 digests, and reads lists of them in the format of `sha256sum`.

use std::fmt::Write;

use sha2::{Digest, Sha256};

/// Returns the SHA-256 digest of `bytes`, in lower-case hexadecimal digits.
#[must_use]
pub fn sha256(bytes: &[u8]) -> String {
    hexadecimal(&Sha256::digest(bytes))
}

/// Returns `bytes` in lower-case hexadecimal digits.
#[must_use]
pub fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().fold(String::with_capacity(2 * bytes.len()), |mut text, byte| {
        // Writing to a string never fails.
        let _ = write!(text, "{byte:02x}");
        text
    })
}

/// Returns the pairs `(name, digest)` in the text of a `SHA256SUMS` file. Lines that start with `#` are comments.
///
/// # Errors
/// A message about the first line that is neither a pair nor a comment.
pub fn read_sums(text: &str) -> Result<Vec<(String, String)>, String> {
    text.lines().filter(|line| !line.starts_with('#')).map(read_line).collect()
}

/// Returns the name and the digest on a line of a list of digests.
fn read_line(line: &str) -> Result<(String, String), String> {
    let is_digest = |text: &str| text.len() == 64 && text.bytes().all(|byte| byte.is_ascii_hexdigit());
    match line.split_once("  ") {
        Some((digest, name)) if is_digest(digest) && !name.is_empty() => Ok((name.to_owned(), digest.to_owned())),
        _ => Err(format!("not a digest and a name: {line}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_digest_of_abc_is_the_standards() {
        // The example with one block in FIPS 180-4.
        let expected = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(sha256(b"abc"), expected);
    }

    #[test]
    fn a_list_of_digests_is_read_without_its_comments() {
        let digest = sha256(b"abc");
        let list = format!("# a comment\n{digest}  statement/1.ppm\n");
        assert_eq!(read_sums(&list), Ok(vec![("statement/1.ppm".to_owned(), digest)]));
    }

    #[test]
    fn a_damaged_list_is_refused() {
        for text in ["abc  1.ppm", &format!("{}  ", sha256(b"")), &format!("{} 1.ppm", sha256(b"")), "\n"] {
            assert!(read_sums(text).is_err(), "{text}");
        }
    }
}
