use crate::dynamic::macros::record;
use crate::types;

record! {
    types::Point { x, y }
    "x" => value(x);
    "y" => value(y);
}

record! {
    types::Segment { from, to, weights }
    "from" => value(from);
    "to" => value(to);
    "weights" => value(weights);
}
