use crate::dynamic::macros::record;

record! {
    crate::mip_3d::Default { class, type_, register, self_, present }
    "class" => value(class);
    "type" => value(type_);
    "register" => value(register);
    "self" => value(self_);
    "present" => value(present);
}
