//! The table of verdicts as CSV, with a column for each driver. Several machines can fill one table.

use std::fmt;

use super::probe::Probe;
use super::report::Run;
use super::verdict::Verdict;

/// The names of the columns before those of the drivers.
const HEAD: [&str; FACTS] = ["probe", "program"];
/// Number of these columns.
const FACTS: usize = 2;

/// A table of verdicts: a line with the names of the columns, and a line for each probe.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Table(Vec<Vec<String>>);

impl Table {
    /// Reads the text of a table, as its `Display` writes it.
    ///
    /// # Errors
    /// A message for the user, if the text is something else.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes());
        let rows: Vec<Vec<String>> =
            reader.deserialize().collect::<Result<_, _>>().map_err(|error| error.to_string())?;
        match rows.first() {
            Some(head) if !head.starts_with(&HEAD.map(str::to_owned)) => {
                Err("it is not a table of verdicts, whose first line begins with \"probe\",\"program\"".to_owned())
            }
            _ => Ok(Self(rows)),
        }
    }

    /// Returns the table with a row for each of `probes`. The verdicts of `run` replace the column of its driver or are
    /// a new column. The other columns stay, without the verdicts on programs that have changed.
    #[must_use]
    pub fn with(&self, probes: &[Probe], run: &Run) -> Self {
        let mut head = self.0.first().cloned().unwrap_or_else(|| HEAD.map(str::to_owned).to_vec());
        if !head.contains(&run.driver) {
            head.push(run.driver.clone());
        }
        let row = |(probe, own): (&Probe, Verdict)| {
            let facts = [probe.name.clone(), probe.result.to_owned()];
            let old = self.0.iter().find(|row| row.starts_with(&facts));
            let verdict = |(column, driver): (usize, &String)| match *driver == run.driver {
                true => own.to_string(),
                false => old.and_then(|row| row.get(column)).cloned().unwrap_or_default(),
            };
            let verdicts: Vec<_> = head.iter().enumerate().skip(FACTS).map(verdict).collect();
            facts.into_iter().chain(verdicts).collect()
        };
        let rows: Vec<_> = probes.iter().zip(run.verdicts(probes)).map(row).collect();
        Self(std::iter::once(head).chain(rows).collect())
    }

    /// Returns name, program and verdict of each probe on the first driver whose description begins with `driver`, or
    /// `None` if there is no such driver.
    #[must_use]
    pub fn column(&self, driver: &str) -> Option<Vec<[&str; FACTS + 1]>> {
        let (head, rows) = self.0.split_first()?;
        let column = (FACTS..head.len()).find(|column| head[*column].starts_with(driver))?;
        Some(rows.iter().map(|row| [0, 1, column].map(|place| row.get(place).map_or("", String::as_str))).collect())
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut writer = csv::WriterBuilder::new().quote_style(csv::QuoteStyle::Always).from_writer(Vec::new());
        self.0.iter().try_for_each(|row| writer.write_record(row)).map_err(|_| fmt::Error)?;
        let text = writer.into_inner().map_err(|_| fmt::Error)?;
        f.write_str(&String::from_utf8_lossy(&text))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conformance::outcome::Outcome;
    use crate::conformance::probes;

    #[test]
    fn a_run_replaces_its_own_column_and_keeps_the_others() {
        let probes = probes::all();
        let run = |adapter: &str, outcome: Outcome| Run {
            driver: format!("{adapter}; a \"driver\""),
            outcomes: vec![outcome; probes.len()],
        };
        let unwritten = |count| Outcome::Unwritten(count);
        let table = Table::default().with(&probes[..3], &run("one", unwritten(1)));
        let table = table.with(&probes[..3], &run("two", unwritten(2)));
        assert_eq!(Table::parse(&table.to_string()).as_ref(), Ok(&table));
        let table = table.with(&probes[1..4], &run("two", unwritten(3)));
        let table = table.with(&probes[1..4], &run("three", Outcome::NotAvailable));
        let verdicts = |driver| table.column(driver).expect("it has run").iter().map(|row| row[2]).collect::<Vec<_>>();
        assert_eq!(verdicts("one"), ["failure: 1 not written", "failure: 1 not written", ""]);
        assert_eq!(verdicts("two"), ["failure: 3 not written"; 3]);
        assert_eq!(verdicts("three"), ["not available (f64)"; 3]);
        assert_eq!(table.column("four"), None);
        assert_eq!(table.to_string().lines().count(), 4);
        assert!(Table::parse("a,b\nc\n").is_err_and(|message| message.contains("line: 2")));
        assert!(Table::parse("a,b\n").is_err_and(|message| message.contains("not a table of verdicts")));
    }
}
