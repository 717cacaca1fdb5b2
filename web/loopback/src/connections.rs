//! The connections of a server. Their number has a limit, which clients without a valid request cannot use up.

use std::collections::BTreeMap;
use std::net::{Shutdown, TcpStream};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Largest number of connections at a time. A browser opens up to six connections to one server.
pub const MAX_CONNECTIONS: usize = 32;

/// The connections that are open, in the order in which they were opened.
#[derive(Debug, Default)]
pub struct Connections(Mutex<State>);

#[derive(Debug, Default)]
struct State {
    /// The number of the next connection.
    next: u64,
    /// The connections that have sent no valid request yet.
    waiting: BTreeMap<u64, Arc<TcpStream>>,
    /// Number of connections whose request is valid.
    valid: usize,
}

/// The place of one connection. It is given back when this value is dropped.
#[derive(Debug)]
pub struct Place<'a> {
    connections: &'a Connections,
    number: u64,
    is_valid: bool,
}

impl Connections {
    fn state(&self) -> MutexGuard<'_, State> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Returns the place of a new connection, or `None` if there is none. If all places are taken, the connection that
    /// has waited longest without a valid request is closed, and the new one gets its place. So silent clients cannot
    /// keep others away.
    pub fn enter(&self, stream: &Arc<TcpStream>) -> Option<u64> {
        let mut state = self.state();
        if state.waiting.len() + state.valid >= MAX_CONNECTIONS {
            let (_, oldest) = state.waiting.pop_first()?;
            // Its thread sees the end of the connection, and ends. An error means that the client has closed it.
            let _ = oldest.shutdown(Shutdown::Both);
        }
        let number = state.next;
        state.waiting.insert(number, Arc::clone(stream));
        state.next += 1;
        Some(number)
    }

    /// Returns the number of places that are taken.
    #[cfg(test)]
    pub fn count(&self) -> usize {
        let state = self.state();
        state.waiting.len() + state.valid
    }

    /// Returns the place that [`Connections::enter`] has given.
    pub const fn place(&self, number: u64) -> Place<'_> {
        Place { connections: self, number, is_valid: false }
    }
}

impl Place<'_> {
    /// Makes the place one of a valid request, which no other client can take. Returns false if it is already taken.
    pub fn keep(&mut self) -> bool {
        let mut state = self.connections.state();
        self.is_valid = state.waiting.remove(&self.number).is_some();
        state.valid += usize::from(self.is_valid);
        self.is_valid
    }
}

impl Drop for Place<'_> {
    fn drop(&mut self) {
        let mut state = self.connections.state();
        state.waiting.remove(&self.number);
        state.valid -= usize::from(self.is_valid);
    }
}

#[cfg(test)]
mod tests {
    use std::net::TcpListener;

    use super::*;

    #[test]
    fn valid_requests_keep_their_places_and_others_give_way_to_newer_ones() {
        let listener = TcpListener::bind("127.0.0.1:0").expect("a port is free");
        let stream = TcpStream::connect(listener.local_addr().expect("it listens")).expect("it listens");
        let stream = Arc::new(stream);
        let connections = Connections::default();
        let enter = || connections.enter(&stream).map(|number| connections.place(number));
        let mut places: Vec<_> = (0..MAX_CONNECTIONS).map(|_| enter().expect("there is a place")).collect();
        // The newest one takes the place of the oldest one, which can then keep none.
        places.push(enter().expect("the oldest gives way"));
        assert_eq!(places.iter_mut().filter_map(|place| place.keep().then_some(())).count(), MAX_CONNECTIONS);
        assert!(!places[0].is_valid && places[1].is_valid);
        assert!(enter().is_none(), "all of them are valid");
        drop(places.remove(0));
        assert!(enter().is_none(), "it had no place to give back");
        drop(places.pop());
        assert!(enter().expect("a place is free").keep());
    }
}
