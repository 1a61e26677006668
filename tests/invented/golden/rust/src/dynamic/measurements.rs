use crate::dynamic::macros::record;

record! {
    crate::measurements::Accel { scaled_accel, valid_flags }
    "scaled_accel" => value(scaled_accel);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::measurements::Numbers { u8, u16, u32, u64, s8, s16, s32, s64, float, double, bool, char }
    "u8" => value(u8);
    "u16" => value(u16);
    "u32" => value(u32);
    "u64" => value(u64);
    "s8" => value(s8);
    "s16" => value(s16);
    "s32" => value(s32);
    "s64" => value(s64);
    "float" => value(float);
    "double" => value(double);
    "bool" => value(bool);
    "char" => value(char);
}

record! {
    crate::measurements::Strings { model, name, rest }
    "model" => value(model);
    "length" => counter(name, "name");
    "name" => value(name);
    "rest" => value(rest);
}

record! {
    crate::measurements::Health { result, code }
    "result" => value(result);
    "code" => value(code);
}

record! {
    crate::measurements::Arrays { modes, flags, vectors, points, track, offsets }
    "modes" => value(modes);
    "flags" => value(flags);
    "vectors" => value(vectors);
    "points" => value(points);
    "track" => value(track);
    "offsets" => value(offsets);
}

record! {
    crate::measurements::Growing { first, second, third }
    "first" => value(first);
    "second" => some_value(second);
    "third" => some_value(third);
}

record! {
    crate::measurements::Radio { connected, strength, noise, gap, gaps }
    "connected" => value(connected);
    "strength" => value(strength);
    "noise" => value(noise);
    "gap" => value(gap);
    "gaps" => value(gaps);
}
