//! Several commands in one packet.

use crate::client::{Client, CommandError, Reason, Request, RequestError, Ticket};
use crate::field::Command;
use crate::protocol::DescriptorSet;

/// Commands of one descriptor set that are sent in one packet: a tuple of references to two to six
/// commands, for [`Device::request_all`](super::Device::request_all).
pub trait Commands {
    /// The descriptor set of the first one, to which all must belong.
    const SET: DescriptorSet;
    /// A tuple of their responses.
    type Responses;
    /// A tuple of their tickets.
    #[doc(hidden)]
    type Tickets;

    #[doc(hidden)]
    fn add(self, request: &mut Request<'_>) -> Result<Self::Tickets, RequestError>;

    #[doc(hidden)]
    fn responses<const N: usize>(
        tickets: &Self::Tickets,
        client: &Client<N>,
    ) -> Result<Self::Responses, CommandError>;
}

macro_rules! commands {
    ($first:ident $($other:ident)*) => {
        #[allow(non_snake_case)]
        impl<$first: Command, $($other: Command),*> Commands for (&$first, $(&$other),*) {
            const SET: DescriptorSet = $first::SET;
            type Responses = ($first::Response, $($other::Response),*);
            type Tickets = (Ticket<$first>, $(Ticket<$other>),*);

            fn add(self, request: &mut Request<'_>) -> Result<Self::Tickets, RequestError> {
                let ($first, $($other),*) = self;
                Ok((request.add($first)?, $(request.add($other)?),*))
            }

            fn responses<const N: usize>(
                tickets: &Self::Tickets,
                client: &Client<N>,
            ) -> Result<Self::Responses, CommandError> {
                let ($first, $($other),*) = tickets;
                Ok((response($first, client)?, $(response($other, client)?),*))
            }
        }
    };
}

commands! { A B }
commands! { A B C }
commands! { A B C D }
commands! { A B C D E }
commands! { A B C D E F }

/// Returns the response to a command that no longer waits, and keeps it.
pub(super) fn response<C: Command, const N: usize>(
    ticket: &Ticket<C>,
    client: &Client<N>,
) -> Result<C::Response, CommandError> {
    client.known(ticket).unwrap_or(Err(CommandError::of::<C>(Reason::Forgotten)))
}
