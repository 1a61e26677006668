//! Tools (0x01): Commands of every shape.

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const TOOLS_SET: u8 = 0x01;

open_enum! {
    /// Which member the union has.
    Shape: u8 {
        /// None.
        NONE = 0, "none";
        /// Circle.
        CIRCLE = 1, "circle";
        /// Path.
        PATH = 2, "path";
        /// Turn.
        TURN = 3, "turn";
        /// Label.
        LABEL = 4, "label";
    }
}

open_enum! {
    /// How a circle is filled.
    Fill: u8 {
        /// Empty.
        EMPTY = 0, "empty";
        /// Solid.
        SOLID = 1, "solid";
        /// Striped.
        STRIPED = 2, "striped";
    }
}

record! {
    /// Two numbers.
    #[derive(Copy, Default)]
    pub struct Stripes {
        /// Of a stripe.
        ///
        /// Unit: m.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub width: f64,
        /// Of all stripes.
        ///
        /// Unit: deg. Range: -180 to 180.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub angle: f32,
    }
}

item! { Stripes { width angle } }
view! {
    Stripes
    width: f64, at 0;
    angle: f32, at 8;
}

constructors! {
    Stripes

    /// Creates it from its values.
    fn new(width: f64, angle: f32);
}

tuple! { Stripes width: f64, angle: f32 }

record! {
    /// Ends in a union of its own.
    #[derive(Copy, Default)]
    pub struct Circle {
        /// The middle.
        pub center: types::Point,
        /// Which member follows.
        pub fill: Fill,
        /// How it is filled.
        ///
        /// Selected by [`fill`](Circle::fill).
        pub filling: CircleFilling,
    }
    wire 17 {
        [center]
        [fill]
        [filling as fill]
    }
}

union! {
    /// The alternatives of `filling` in [`Circle`].
    #[derive(Copy)]
    pub enum CircleFilling: Fill {
        /// Empty.
        ///
        /// Empty if [`fill`](Circle::fill) is [`Fill::EMPTY`].
        #[cfg_attr(feature = "serde", serde(rename = "empty"))]
        EMPTY => Empty,
        /// A colour.
        ///
        /// If [`fill`](Circle::fill) is [`Fill::SOLID`].
        #[cfg_attr(feature = "serde", serde(rename = "solid"))]
        SOLID => Solid(u32) "solid",
        /// Striped.
        ///
        /// If [`fill`](Circle::fill) is [`Fill::STRIPED`].
        #[cfg_attr(feature = "serde", serde(rename = "striped"))]
        STRIPED => Striped(Stripes) "striped",
    }
    default CircleFilling::Empty
}

item! { Circle { center fill filling } }
constructors! {
    Circle

    /// Creates it from its values.
    fn new(center: types::Point, filling: CircleFilling), fill: filling.tag();
}

record! {
    /// A counted array at its end.
    ///
    /// The wire format also contains `num_points`: Number of points. Counts the elements of
    /// [`points`](Path::points).
    #[derive(Default, Eq, Hash)]
    pub struct Path {
        /// Does it return to its start?
        pub closed: crate::Bool,
        /// The points.
        pub points: crate::List<types::Point, 62>,
    }
    wire 250 {
        [closed]
        [num_points: u8 counts points]
        [points by num_points]
    }
}

item! { Path { closed points } }
constructors! {
    Path

    /// Creates it from its values.
    fn new(closed: bool, points: impl Into<crate::List<types::Point, 62>>);
}

tuple! { Path closed: crate::Bool, points: crate::List<types::Point, 62> }

open_enum! {
    /// What drives a pin.
    Drive: u8 {
        /// Off.
        OFF = 0, "off";
        /// Pulse.
        PULSE = 1, "pulse";
        /// Serial.
        SERIAL = 2, "serial";
    }
}

open_enum! {
    /// Of a pulse.
    PulseUse: u8 {
        /// Input.
        INPUT = 1, "input";
        /// Output.
        OUTPUT = 2, "output";
    }
}

open_enum! {
    /// Of a serial line.
    SerialUse: u8 {
        /// Receive.
        RECEIVE = 1, "receive";
        /// Transmit.
        TRANSMIT = 33, "transmit";
    }
}

record! {
    /// One of a list; what it is depends on what was asked for.
    #[derive(Copy, Default)]
    pub struct Reading {
        /// Of the reading.
        pub kind: u8,
        /// Of the reading.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub value: f32,
    }
}

item! { Reading { kind value } }
view! {
    Reading
    kind: u8, at 0;
    value: f32, at 1;
}

constructors! {
    Reading

    /// Creates it from its values.
    fn new(kind: u8, value: f32);
}

tuple! { Reading kind: u8, value: f32 }

bitfield! {
    /// Of the model A.
    ModelAFaults: u32 {
        /// Clock. Bit 0.
        CLOCK: bool = 0,
            clock, set_clock, with_clock;
        /// The sensor is broken. Bit 8. Concerns
        /// [`measurements::Accel`](crate::measurements::Accel) and [`CaptureBias`].
        SENSOR: bool = 8,
            sensor, set_sensor, with_sensor;
        /// Solution. Bit 24.
        SOLUTION: bool = 24,
            solution, set_solution, with_solution;
    }
}

bitfield! {
    /// Of the model B.
    ModelBFaults: u32 {
        /// General. Bit 0.
        GENERAL: bool = 0,
            general, set_general, with_general;
        /// Overload. Bit 1.
        OVERLOAD: bool = 1,
            overload, set_overload, with_overload;
        /// Accel. Bit 12.
        ACCEL: bool = 12,
            accel, set_accel, with_accel;
    }
}

record! {
    /// Ping (0x01,0x01).
    ///
    /// Tests the line.
    ///
    /// Supported by [Model A](crate::devices::MODEL_A), [Model B](crate::devices::MODEL_B), [Model
    /// C](crate::devices::MODEL_C) and [Old 1](crate::devices::OLD_1).
    ///
    /// Source: guide: Ping; leaflet: Ping.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct Ping;
}

constructors! {
    Ping

    /// Creates the command from its parameters.
    fn new();
}

field! {
    Ping: 0x01, "tools.ping";
    in [0x01];
}

command! {
    Ping -> ();
}

record! {
    /// Settings (0x01,0x02).
    ///
    /// Every function, and a prefix of parameters for each.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD),
    /// [default](types::FunctionSelector::DEFAULT) and [apply](types::FunctionSelector::APPLY).
    /// Response: [`SettingsResponse`]. Supported by [Model A](crate::devices::MODEL_A), [Model
    /// B](crate::devices::MODEL_B) and [Model C](crate::devices::MODEL_C). On the [Model
    /// B](crate::devices::MODEL_B): [write](types::FunctionSelector::WRITE) and
    /// [read](types::FunctionSelector::READ) only. On the [Model C](crate::devices::MODEL_C):
    /// [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ) and
    /// [save](types::FunctionSelector::SAVE) only.
    ///
    /// Source: guide: Settings; leaflet: Settings.
    #[derive(Copy, Eq, Hash)]
    pub struct Settings {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Number of the port, 0 for all.
        ///
        /// Range: 0 to 8.
        pub port: Option<u8>,
        /// What to do.
        ///
        /// Default: [`types::Mode::FAST`]. Required for [write](types::FunctionSelector::WRITE),
        /// [read](types::FunctionSelector::READ) and [apply](types::FunctionSelector::APPLY). On
        /// the [Model C](crate::devices::MODEL_C): only [`types::Mode::DEFAULT`] and
        /// [`types::Mode::FAST`]; not deprecated.
        pub mode: Option<types::Mode>,
        /// Speed.
        ///
        /// Unit: Bd. Default: 115200. Required for [write](types::FunctionSelector::WRITE) and
        /// [apply](types::FunctionSelector::APPLY).
        pub baud: Option<u32>,
        /// Required by no function, not even by write.
        ///
        /// Optional. If [`mode`](Settings::mode) is [`types::Mode::FAST`]: unit s; range 1 to 10;
        /// default 5. If [`mode`](Settings::mode) is [`types::Mode::SLOW`]: unit m.
        pub limit: Option<u16>,
        /// Reserved: send 1. Optional.
        pub reserved: Option<u8>,
    }
    wire 10 {
        [function selects]
        [port for WRITE READ SAVE LOAD DEFAULT APPLY]
        [mode for WRITE READ APPLY]
        [baud for WRITE APPLY]
        [limit optional]
        [reserved optional]
    }
}

constructors! {
    Settings

    /// Apply the new setting.
    fn write(
        port: u8,
        mode: types::Mode,
        baud: u32,
    ) -> Write;

    /// Send the current setting back in a response.
    fn read(port: u8, mode: types::Mode) -> Read;

    /// Save the current setting to non-volatile memory.
    fn save(port: u8) -> Save;

    /// Load the saved setting.
    fn load(port: u8) -> Load;

    /// Load the factory default setting.
    fn load_default(port: u8) -> LoadDefault;

    /// Apply the new setting and send no acknowledge (5-series devices).
    fn apply(
        port: u8,
        mode: types::Mode,
        baud: u32,
    ) -> Apply;
}

setters! {
    call Settings
    fn with_limit(limit: u16);
    fn with_reserved(reserved: u8);
}

field! {
    Settings: 0x02, "tools.settings";
    in [0x01];
}

command! {
    Settings -> Option<SettingsResponse>;
    for WRITE SAVE LOAD DEFAULT APPLY -> ();
    for READ -> SettingsResponse;
    responds SettingsResponse for READ;
    silent for APPLY;
}

record! {
    /// Set time (0x01,0x03).
    ///
    /// Two responses for one command.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ)
    /// and [apply](types::FunctionSelector::APPLY). Response: [`SetTimeFastResponse`] or
    /// [`SetTimeSlowResponse`]. Supported by [Model A](crate::devices::MODEL_A) and [Model
    /// C](crate::devices::MODEL_C).
    ///
    /// - Send it once a second.
    ///
    /// Source: guide: Set time.
    #[derive(Copy, Eq, Hash)]
    pub struct SetTime {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Which half of the time.
        pub part: Option<types::Mode>,
        /// The new value.
        ///
        /// Unit: s. Required for [write](types::FunctionSelector::WRITE) and
        /// [apply](types::FunctionSelector::APPLY).
        pub value: Option<u32>,
    }
    wire 6 {
        [function selects]
        [part for WRITE READ APPLY]
        [value for WRITE APPLY]
    }
}

constructors! {
    SetTime

    /// Apply the new setting.
    fn write(part: types::Mode, value: u32) -> Write;

    /// Send the current setting back in a response.
    fn read(part: types::Mode) -> Read;

    /// Apply the new setting and send no acknowledge (5-series devices).
    fn apply(part: types::Mode, value: u32) -> Apply;
}

field! {
    SetTime: 0x03, "tools.set_time";
    in [0x01];
}

command! {
    SetTime -> Option<SetTimeResponses>;
    for WRITE APPLY -> ();
    for READ -> SetTimeResponses;
    responds SetTimeFastResponse for READ, if part = Some(types::Mode::FAST);
    responds SetTimeSlowResponse for READ, if part = Some(types::Mode::SLOW);
    silent for APPLY;
}

responses! {
    /// The response to [`SetTime`].
    #[derive(Copy, Eq, Hash)]
    pub enum SetTimeResponses {
        /// The response [`SetTimeFastResponse`].
        #[cfg_attr(feature = "serde", serde(rename = "set_time_fast_response"))]
        Fast(SetTimeFastResponse),
        /// The response [`SetTimeSlowResponse`].
        #[cfg_attr(feature = "serde", serde(rename = "set_time_slow_response"))]
        Slow(SetTimeSlowResponse),
    }
}

record! {
    /// Status (0x01,0x04).
    ///
    /// Layouts of one response, told apart by constants and by size.
    ///
    /// For advanced use. Response: [`StatusPaged`], [`StatusShort`], [`StatusLong`], [`StatusOld`]
    /// or [`StatusFull`]. The device may take 2.5 s to reply. Supported by [Model
    /// A](crate::devices::MODEL_A), [Model B](crate::devices::MODEL_B) and [Model
    /// C](crate::devices::MODEL_C).
    ///
    /// The wire format also contains `model`: The model that the layouts belong to. Always 4711.
    ///
    /// Source: guide: Status.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct Status {
        /// Which layout.
        ///
        /// Range: 1 to 2. On the [Model C](crate::devices::MODEL_C): always 2. Inferred: It has one
        /// layout.
        pub selector: u8,
    }
    wire 3 {
        [model: u16 = 4711]
        [selector]
    }
}

constructors! {
    Status

    /// Creates the command from its parameters.
    fn new(selector: u8);
}

field! {
    Status: 0x04, "tools.status";
    in [0x01];
    constants [0: 18 103];
}

command! {
    Status -> StatusResponses;
    responds StatusPaged | StatusShort, if selector = 1;
    responds StatusLong | StatusOld | StatusFull, if selector = 2;
    timeout 2500;
}

responses! {
    /// The response to [`Status`].
    #[derive(Copy, Eq, Hash)]
    pub enum StatusResponses {
        /// The response [`StatusPaged`].
        #[cfg_attr(feature = "serde", serde(rename = "status_paged"))]
        Paged(StatusPaged),
        /// The response [`StatusShort`].
        #[cfg_attr(feature = "serde", serde(rename = "status_short"))]
        Short(StatusShort),
        /// The response [`StatusLong`].
        #[cfg_attr(feature = "serde", serde(rename = "status_long"))]
        Long(StatusLong),
        /// The response [`StatusOld`].
        #[cfg_attr(feature = "serde", serde(rename = "status_old"))]
        Old(StatusOld),
        /// The response [`StatusFull`].
        #[cfg_attr(feature = "serde", serde(rename = "status_full"))]
        Full(StatusFull),
    }
}

record! {
    /// Bias (0x01,0x05).
    ///
    /// Its response serves another command too.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`BiasVector`]. Changes
    /// [`measurements::Accel`](crate::measurements::Accel) and
    /// [`measurements::Gust`](crate::measurements::Gust). Probably changes more (0x81). Supported
    /// by [Model A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Bias; leaflet: Bias.
    #[derive(Copy)]
    pub struct Bias {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Taken off the measurement.
        ///
        /// Elements: x, y, z. Unit: g. Frame: sensor. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub bias: Option<types::Vector3f>,
    }
    wire 13 {
        [function selects]
        [bias for WRITE]
    }
}

constructors! {
    Bias

    /// Apply the new setting.
    fn write(bias: impl Into<types::Vector3f>) -> Write;

    /// Send the current setting back in a response.
    fn read() -> Read;

    /// Save the current setting to non-volatile memory.
    fn save() -> Save;

    /// Load the saved setting.
    fn load() -> Load;

    /// Load the factory default setting.
    fn load_default() -> LoadDefault;
}

field! {
    Bias: 0x05, "tools.bias";
    in [0x01];
}

command! {
    Bias -> Option<BiasVector>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> BiasVector;
    responds BiasVector for READ;
}

record! {
    /// Capture bias (0x01,0x06).
    ///
    /// Measures the bias.
    ///
    /// Response: [`BiasVector`]. Probably changes
    /// [`measurements::Accel`](crate::measurements::Accel). Supported by [Model
    /// A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C). Deprecated on the [Model
    /// C](crate::devices::MODEL_C): use [`Bias`] instead. On the [Model
    /// C](crate::devices::MODEL_C): firmware \>= 1.0, \< 1.1.
    ///
    /// Source: guide: Capture bias.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct CaptureBias {
        /// How long.
        ///
        /// Unit: s. Range: 1 to 30.
        pub time: u16,
    }
}

constructors! {
    CaptureBias

    /// Creates the command from its parameters.
    fn new(time: u16);
}

field! {
    CaptureBias: 0x06, "tools.capture_bias";
    in [0x01];
}

command! {
    CaptureBias -> BiasVector;
    responds BiasVector;
}

record! {
    /// Formats (0x01,0x07).
    ///
    /// Counted arrays of structures and of numbers; not answered if told so.
    ///
    /// Not acknowledged if [`suppress_ack`](Formats::suppress_ack) is true. Supported by [Model
    /// A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C).
    ///
    /// The wire format also contains `num_segments`: Number of segments. Counts the elements of
    /// [`segments`](Formats::segments).
    ///
    /// Source: guide: Formats.
    #[derive(Default, Eq, Hash)]
    pub struct Formats {
        /// Send no acknowledge.
        pub suppress_ack: crate::Bool,
        /// Between a counter and its array.
        ///
        /// Deprecated.
        pub checkpoint: u8,
        /// The segments.
        pub segments: crate::List<types::Segment, 25>,
    }
    wire 253 {
        [suppress_ack]
        [num_segments: u8 counts segments]
        [checkpoint]
        [segments by num_segments]
    }
}

constructors! {
    Formats

    /// Creates the command from its parameters.
    fn new(
        suppress_ack: bool,
        checkpoint: u8,
        segments: impl Into<crate::List<types::Segment, 25>>,
    );
}

field! {
    Formats: 0x07, "tools.formats";
    in [0x01];
}

command! {
    Formats -> ();
    silent if suppress_ack = crate::Bool(1);
}

record! {
    /// Choice (0x01,0x08).
    ///
    /// A tagged union with an empty variant, nested unions, arrays and strings in it.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE) and
    /// [read](types::FunctionSelector::READ). Response: [`ChoiceResponse`]. Supported by [Model
    /// A](crate::devices::MODEL_A).
    ///
    /// Source: guide: Choice.
    pub struct Choice {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Which one.
        pub instance: Option<u8>,
        /// Which member follows.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub shape: Option<Shape>,
        /// The member.
        ///
        /// Selected by [`shape`](Choice::shape). Required for
        /// [write](types::FunctionSelector::WRITE).
        pub parameters: Option<ChoiceParameters>,
    }
    wire 253 {
        [function selects]
        [instance for WRITE READ]
        [shape for WRITE]
        [parameters as shape for WRITE]
    }
}

union! {
    /// The alternatives of `parameters` in [`Choice`].
    pub enum ChoiceParameters: Shape {
        /// None.
        ///
        /// Empty if [`shape`](Choice::shape) is [`Shape::NONE`].
        #[cfg_attr(feature = "serde", serde(rename = "none"))]
        NONE => None,
        /// Circle.
        ///
        /// If [`shape`](Choice::shape) is [`Shape::CIRCLE`].
        #[cfg_attr(feature = "serde", serde(rename = "circle"))]
        CIRCLE => Circle(Circle) "circle",
        /// Path.
        ///
        /// If [`shape`](Choice::shape) is [`Shape::PATH`].
        #[cfg_attr(feature = "serde", serde(rename = "path"))]
        PATH => Path(Path) "path",
        /// A rotation.
        ///
        /// If [`shape`](Choice::shape) is [`Shape::TURN`]. Elements: w, x, y, z. Unit: 1.
        #[cfg_attr(feature = "serde", serde(rename = "turn"))]
        TURN => Turn(types::Quatf) "rotation",
        /// A name.
        ///
        /// If [`shape`](Choice::shape) is [`Shape::LABEL`].
        #[cfg_attr(feature = "serde", serde(rename = "label"))]
        LABEL => Label(crate::Text<8>) "label",
    }
    default ChoiceParameters::None
}

constructors! {
    Choice

    /// Apply the new setting.
    fn write(instance: u8, parameters: ChoiceParameters) -> Write, shape: parameters.tag();

    /// Send the current setting back in a response.
    fn read(instance: u8) -> Read;
}

field! {
    Choice: 0x08, "tools.choice";
    in [0x01];
}

command! {
    Choice -> Option<ChoiceResponse>;
    for WRITE -> ();
    for READ -> ChoiceResponse;
    responds ChoiceResponse for READ;
}

record! {
    /// List (0x01,0x09).
    ///
    /// Optional counted array; a read may carry a zero count.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ)
    /// and [save](types::FunctionSelector::SAVE). Response: [`ListResponse`]. Supported by [Model
    /// A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C).
    ///
    /// The wire format also contains `count`: Number of items. Counts the elements of
    /// [`items`](List::items). Required for [write](types::FunctionSelector::WRITE).
    ///
    /// Source: guide: List.
    #[derive(Eq, Hash)]
    pub struct List {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// The items.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub items: Option<crate::List<u16, 125>>,
    }
    wire 252 {
        [function selects]
        [(items) for WRITE {
            [count: u8 counts items]
            [items by count]
        }]
    }
}

constructors! {
    List

    /// Apply the new setting.
    fn write(items: impl Into<crate::List<u16, 125>>) -> Write;

    /// Send the current setting back in a response.
    fn read() -> Read;

    /// Save the current setting to non-volatile memory.
    fn save() -> Save;
}

field! {
    List: 0x09, "tools.list";
    in [0x01];
}

command! {
    List -> Option<ListResponse>;
    for WRITE SAVE -> ();
    for READ -> ListResponse;
    responds ListResponse for READ;
}

record! {
    /// Inventory (0x01,0x0A).
    ///
    /// Answers with an array to the end of the field.
    ///
    /// Response: [`InventoryResponse`]. Supported by [Model A](crate::devices::MODEL_A) and [Model
    /// C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Inventory.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct Inventory;
}

constructors! {
    Inventory

    /// Creates the command from its parameters.
    fn new();
}

field! {
    Inventory: 0x0A, "tools.inventory";
    in [0x01];
}

command! {
    Inventory -> InventoryResponse;
    responds InventoryResponse;
}

record! {
    /// Pin (0x01,0x0B).
    ///
    /// The names of one number depend on another.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE) and
    /// [read](types::FunctionSelector::READ). Response: [`PinResponse`]. Supported by [Model
    /// A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Pin.
    #[derive(Copy, Eq, Hash)]
    pub struct Pin {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// What drives it.
        pub drive: Option<Drive>,
        /// How it is used.
        ///
        /// Required for [write](types::FunctionSelector::WRITE). If [`drive`](Pin::drive) is
        /// [`Drive::PULSE`]: values of [`PulseUse`]. If [`drive`](Pin::drive) is [`Drive::SERIAL`]:
        /// values of [`SerialUse`].
        #[cfg_attr(feature = "serde", serde(rename = "use"))]
        pub use_: Option<u8>,
    }
    wire 3 {
        [function selects]
        [drive for WRITE READ]
        [use_ "use" for WRITE]
    }
}

constructors! {
    Pin

    /// Apply the new setting.
    fn write(drive: Drive, use_: u8) -> Write;

    /// Send the current setting back in a response.
    fn read(drive: Drive) -> Read;
}

#[rustfmt::skip]
impl Pin {
    /// Reads `use_` as [`PulseUse`].
    ///
    /// If [`drive`](Pin::drive) is [`Drive::PULSE`]: values of [`PulseUse`].
    #[inline]
    #[must_use]
    pub fn use_as_pulse_use(&self) -> Option<PulseUse> {
        let named = matches!(self.drive, Some(Drive::PULSE));
        self.use_.filter(|_| named).map(Into::into)
    }

    /// Reads `use_` as [`SerialUse`].
    ///
    /// If [`drive`](Pin::drive) is [`Drive::SERIAL`]: values of [`SerialUse`].
    #[inline]
    #[must_use]
    pub fn use_as_serial_use(&self) -> Option<SerialUse> {
        let named = matches!(self.drive, Some(Drive::SERIAL));
        self.use_.filter(|_| named).map(Into::into)
    }
}

field! {
    Pin: 0x0B, "tools.pin";
    in [0x01];
}

command! {
    Pin -> Option<PinResponse>;
    for WRITE -> ();
    for READ -> PinResponse;
    responds PinResponse for READ;
}

record! {
    /// Hello (0x01,0x0C).
    ///
    /// The device asks and a host answers.
    ///
    /// No device is known for certain to support it. Also called `keep_alive`. Response:
    /// [`HelloResponse`]. Sent by the device; the host replies. Known only from the Kit of names.
    ///
    /// Source: sheet: Hello.
    #[derive(Copy)]
    pub struct Hello {
        /// Reserved: send 1.0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub reserved: f32,
        /// Reserved: send 0.0. Optional.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub later: Option<[f64; 2]>,
    }
    wire 20 {
        [reserved]
        [later optional]
    }
}

#[rustfmt::skip]
impl core::default::Default for Hello {
    fn default() -> Self {
        Self {
            reserved: 1.0,
            later: None,
        }
    }
}

constructors! {
    Hello

    /// Creates the command from its parameters.
    fn new(), reserved: 1.0, later: None;
}

setters! {
    Hello
    fn with_later(later: [f64; 2]);
}

field! {
    Hello: 0x0C, "tools.hello";
    in [0x01];
}

command! {
    Hello -> HelloResponse;
    responds HelloResponse;
}

record! {
    /// Readings (0x01,0x0D).
    ///
    /// A parameter outside of a structure says how its members are read.
    ///
    /// Response: [`ReadingsResponse`]. Supported by [Model A](crate::devices::MODEL_A) and [Model
    /// C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Readings.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct Readings {
        /// What is asked for.
        pub drive: Drive,
    }
}

constructors! {
    Readings

    /// Creates the command from its parameters.
    fn new(drive: Drive);
}

field! {
    Readings: 0x0D, "tools.readings";
    in [0x01];
}

command! {
    Readings -> ReadingsResponse;
    responds ReadingsResponse;
}

record! {
    /// Poll (0x01,0x0E).
    ///
    /// Descriptors of a set that a parameter names, and of one that is always the same.
    ///
    /// Supported by [Model C](crate::devices::MODEL_C).
    ///
    /// The wire format also contains `count`: Number of fields. Counts the elements of
    /// [`descriptors`](Poll::descriptors).
    ///
    /// Source: guide: Formats.
    #[derive(Default, Eq, Hash)]
    pub struct Poll {
        /// Data descriptor set.
        ///
        /// Range: 0x80 to 0xFE.
        pub descriptor_set: u8,
        /// Field descriptor.
        ///
        /// Refers to fields of Measurements. Default: 0x01.
        pub first: u8,
        /// Field descriptors.
        ///
        /// Refers to fields of [`descriptor_set`](Poll::descriptor_set).
        pub descriptors: crate::List<u8, 250>,
    }
    wire 253 {
        [descriptor_set]
        [first]
        [count: u8 counts descriptors]
        [descriptors by count]
    }
}

constructors! {
    Poll

    /// Creates the command from its parameters.
    fn new(
        descriptor_set: u8,
        first: u8,
        descriptors: impl Into<crate::List<u8, 250>>,
    );
}

field! {
    Poll: 0x0E, "tools.poll";
    in [0x01];
}

command! {
    Poll -> ();
}

record! {
    /// Settings response (0x01,0x82).
    ///
    /// Response to [`Settings`]. Supported by [Model A](crate::devices::MODEL_A), [Model
    /// B](crate::devices::MODEL_B) and [Model C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Settings; leaflet: Settings.
    #[derive(Copy, Eq, Hash)]
    pub struct SettingsResponse {
        /// Number of the port, 0 for all.
        ///
        /// Range: 0 to 8.
        pub port: u8,
        /// What to do.
        ///
        /// Default: [`types::Mode::FAST`].
        pub mode: types::Mode,
        /// Speed.
        ///
        /// Unit: Bd. Default: 115200.
        pub baud: u32,
        /// Required by no function, not even by write.
        ///
        /// If [`mode`](SettingsResponse::mode) is [`types::Mode::FAST`]: unit s; range 1 to 10;
        /// default 5. If [`mode`](SettingsResponse::mode) is [`types::Mode::SLOW`]: unit m.
        pub limit: u16,
        /// Reserved.
        pub reserved: u8,
    }
}

#[rustfmt::skip]
impl core::default::Default for SettingsResponse {
    fn default() -> Self {
        Self {
            port: core::default::Default::default(),
            mode: core::default::Default::default(),
            baud: core::default::Default::default(),
            limit: core::default::Default::default(),
            reserved: 1,
        }
    }
}

view! {
    SettingsResponse
    port: u8, at 0;
    mode: types::Mode, at 1;
    baud: u32, at 2;
    limit: u16, at 6;
    reserved: u8, at 8;
}

constructors! {
    SettingsResponse

    /// Creates it from its values.
    fn new(
        port: u8,
        mode: types::Mode,
        baud: u32,
        limit: u16,
    ), reserved: 1;
}

field! {
    SettingsResponse: 0x82, "tools.settings_response";
    in [0x01];
    answers Settings;
}

record! {
    /// Set time response (0x01,0x83).
    ///
    /// Response to [`SetTime`]. Sent if [`part`](SetTime::part) is [`types::Mode::FAST`]. Supported
    /// by [Model A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Set time.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct SetTimeFastResponse {
        /// The fast half.
        ///
        /// Unit: s.
        pub value: u32,
    }
}

view! {
    SetTimeFastResponse
    value: u32, at 0;
}

constructors! {
    SetTimeFastResponse

    /// Creates it from its values.
    fn new(value: u32);
}

field! {
    SetTimeFastResponse: 0x83, "tools.set_time_fast_response";
    in [0x01];
    answers SetTime;
}

record! {
    /// Set time response (0x01,0x84).
    ///
    /// Response to [`SetTime`]. Sent if [`part`](SetTime::part) is [`types::Mode::SLOW`]. Supported
    /// by [Model A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Set time.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct SetTimeSlowResponse {
        /// The slow half.
        ///
        /// Unit: s.
        pub value: u32,
    }
}

view! {
    SetTimeSlowResponse
    value: u32, at 0;
}

constructors! {
    SetTimeSlowResponse

    /// Creates it from its values.
    fn new(value: u32);
}

field! {
    SetTimeSlowResponse: 0x84, "tools.set_time_slow_response";
    in [0x01];
    answers SetTime;
}

record! {
    /// Choice response (0x01,0x88).
    ///
    /// Response to [`Choice`]. Supported by [Model A](crate::devices::MODEL_A).
    ///
    /// Source: guide: Choice.
    #[derive(Default)]
    pub struct ChoiceResponse {
        /// Which one.
        pub instance: u8,
        /// Which member follows.
        pub shape: Shape,
        /// The member.
        ///
        /// Selected by [`shape`](ChoiceResponse::shape).
        pub parameters: ChoiceParameters,
    }
    wire 252 {
        [instance]
        [shape]
        [parameters as shape]
    }
}

constructors! {
    ChoiceResponse

    /// Creates it from its values.
    fn new(instance: u8, parameters: ChoiceParameters), shape: parameters.tag();
}

field! {
    ChoiceResponse: 0x88, "tools.choice_response";
    in [0x01];
    answers Choice;
}

record! {
    /// List response (0x01,0x89).
    ///
    /// Response to [`List`]. Supported by [Model A](crate::devices::MODEL_A) and [Model
    /// C](crate::devices::MODEL_C).
    ///
    /// The wire format also contains `count`: Number of items. Counts the elements of
    /// [`items`](ListResponse::items).
    ///
    /// Source: guide: List.
    #[derive(Default, Eq, Hash)]
    pub struct ListResponse {
        /// The items.
        pub items: crate::List<u16, 126>,
    }
    wire 253 {
        [count: u8 counts items]
        [items by count]
    }
}

constructors! {
    ListResponse

    /// Creates it from its values.
    fn new(items: impl Into<crate::List<u16, 126>>);
}

field! {
    ListResponse: 0x89, "tools.list_response";
    in [0x01];
    answers List;
}

record! {
    /// Inventory response (0x01,0x8A).
    ///
    /// Response to [`Inventory`]. Supported by [Model A](crate::devices::MODEL_A) and [Model
    /// C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Inventory.
    #[derive(Default, Eq, Hash)]
    pub struct InventoryResponse {
        /// As many as there are.
        pub descriptors: crate::List<u16, 126>,
    }
}

constructors! {
    InventoryResponse

    /// Creates it from its values.
    fn new(descriptors: impl Into<crate::List<u16, 126>>);
}

field! {
    InventoryResponse: 0x8A, "tools.inventory_response";
    in [0x01];
    answers Inventory;
}

record! {
    /// Pin response (0x01,0x8B).
    ///
    /// Response to [`Pin`]. Supported by [Model A](crate::devices::MODEL_A) and [Model
    /// C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Pin.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct PinResponse {
        /// What drives it now.
        pub drive: Drive,
        /// How it is used.
        ///
        /// If [`drive`](PinResponse::drive) is [`Drive::PULSE`]: values of [`PulseUse`]. If
        /// [`drive`](PinResponse::drive) is [`Drive::SERIAL`]: values of [`SerialUse`].
        #[cfg_attr(feature = "serde", serde(rename = "use"))]
        pub use_: u8,
    }
    wire 2 {
        [drive]
        [use_ "use"]
    }
}

view! {
    PinResponse
    drive: Drive, at 0;
    use_: u8, at 1;
}

constructors! {
    PinResponse

    /// Creates it from its values.
    fn new(drive: Drive, use_: u8);
}

#[rustfmt::skip]
impl PinResponse {
    /// Reads `use_` as [`PulseUse`].
    ///
    /// If [`drive`](PinResponse::drive) is [`Drive::PULSE`]: values of [`PulseUse`].
    #[inline]
    #[must_use]
    pub fn use_as_pulse_use(&self) -> Option<PulseUse> {
        let named = matches!(self.drive, Drive::PULSE);
        named.then(|| self.use_.into())
    }

    /// Reads `use_` as [`SerialUse`].
    ///
    /// If [`drive`](PinResponse::drive) is [`Drive::SERIAL`]: values of [`SerialUse`].
    #[inline]
    #[must_use]
    pub fn use_as_serial_use(&self) -> Option<SerialUse> {
        let named = matches!(self.drive, Drive::SERIAL);
        named.then(|| self.use_.into())
    }
}

field! {
    PinResponse: 0x8B, "tools.pin_response";
    in [0x01];
    answers Pin;
}

record! {
    /// Hello response (0x01,0x8C).
    ///
    /// No device is known for certain to support it. Also called `keep_alive_response` and
    /// `welcome`. Response to [`Hello`]. Known only from the Kit of names. Uncertain: When it
    /// comes.
    ///
    /// Source: sheet: Hello.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct HelloResponse {
        /// When the device was seen.
        ///
        /// Unit: s.
        pub seen: u32,
    }
}

view! {
    HelloResponse
    seen: u32, at 0;
}

constructors! {
    HelloResponse

    /// Creates it from its values.
    fn new(seen: u32);
}

field! {
    HelloResponse: 0x8C, "tools.hello_response";
    in [0x01];
    answers Hello;
}

record! {
    /// Readings response (0x01,0x8D).
    ///
    /// Response to [`Readings`]. Supported by [Model A](crate::devices::MODEL_A) and [Model
    /// C](crate::devices::MODEL_C).
    ///
    /// The wire format also contains `count`: Number of readings. Counts the elements of
    /// [`readings`](ReadingsResponse::readings).
    ///
    /// Source: guide: Readings.
    #[derive(Default)]
    pub struct ReadingsResponse {
        /// What was asked for.
        pub drive: Drive,
        /// The readings.
        ///
        /// If [`drive`](ReadingsResponse::drive) is [`Drive::PULSE`]: [`kind`](Reading::kind) has
        /// values of [`PulseUse`]. Seldom 2. If [`drive`](ReadingsResponse::drive) is
        /// [`Drive::SERIAL`]: [`kind`](Reading::kind) has values of [`SerialUse`].
        pub readings: crate::List<Reading, 49>,
        /// The last one.
        ///
        /// If [`drive`](ReadingsResponse::drive) is [`Drive::PULSE`]: [`value`](Reading::value) has
        /// unit s; range 0 to 1. If [`drive`](ReadingsResponse::drive) is [`Drive::SERIAL`]:
        /// [`value`](Reading::value): Nothing.
        pub last: Reading,
    }
    wire 252 {
        [drive]
        [count: u8 counts readings]
        [readings by count]
        [last]
    }
}

constructors! {
    ReadingsResponse

    /// Creates it from its values.
    fn new(
        drive: Drive,
        readings: impl Into<crate::List<Reading, 49>>,
        last: Reading,
    );
}

field! {
    ReadingsResponse: 0x8D, "tools.readings_response";
    in [0x01];
    answers Readings;
}

record! {
    /// Status response (0x01,0x90).
    ///
    /// As long as the short layout. A further constant tells it from that one.
    ///
    /// Response to [`Status`]. Sent if [`selector`](Status::selector) is 1. Supported by [Model
    /// C](crate::devices::MODEL_C).
    ///
    /// The wire format also contains `model`: The model. Always 4711.
    ///
    /// The wire format also contains `selector`: The short layout. Always 1.
    ///
    /// The wire format also contains `page`: The page. Always 7.
    ///
    /// Source: guide: Status.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct StatusPaged {
        /// Since start.
        ///
        /// Unit: s.
        pub uptime: u16,
        /// How full it is.
        pub level: u8,
    }
    wire 7 {
        [model: u16 = 4711]
        [selector: u8 = 1]
        [page: u8 = 7]
        [uptime]
        [level]
    }
}

constructors! {
    StatusPaged

    /// Creates it from its values.
    fn new(uptime: u16, level: u8);
}

field! {
    StatusPaged: 0x90, "tools.status_paged";
    in [0x01];
    constants [0: 18 103] [2: 1] [3: 7];
    answers Status;
}

record! {
    /// Status response (0x01,0x90).
    ///
    /// Response to [`Status`]. Sent if [`selector`](Status::selector) is 1. Supported by [Model
    /// A](crate::devices::MODEL_A) and [Model B](crate::devices::MODEL_B).
    ///
    /// The wire format also contains `model`: The model. Always 4711.
    ///
    /// The wire format also contains `selector`: The short layout. Always 1.
    ///
    /// Source: guide: Status.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct StatusShort {
        /// Faults.
        ///
        /// On the [Model A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C): values
        /// of [`ModelAFaults`]. On the [Model B](crate::devices::MODEL_B): values of
        /// [`ModelBFaults`].
        pub flags: u32,
    }
    wire 7 {
        [model: u16 = 4711]
        [selector: u8 = 1]
        [flags]
    }
}

constructors! {
    StatusShort

    /// Creates it from its values.
    fn new(flags: u32);
}

#[rustfmt::skip]
impl StatusShort {
    /// Reads `flags` as [`ModelAFaults`].
    ///
    /// On the [Model A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C): values of
    /// [`ModelAFaults`].
    #[inline]
    #[must_use]
    pub fn flags_as_model_a_faults(&self) -> ModelAFaults {
        self.flags.into()
    }

    /// Reads `flags` as [`ModelBFaults`].
    ///
    /// On the [Model B](crate::devices::MODEL_B): values of [`ModelBFaults`].
    #[inline]
    #[must_use]
    pub fn flags_as_model_b_faults(&self) -> ModelBFaults {
        self.flags.into()
    }
}

field! {
    StatusShort: 0x90, "tools.status_short";
    in [0x01];
    constants [0: 18 103] [2: 1];
    answers Status;
}

record! {
    /// Status response (0x01,0x90).
    ///
    /// Response to [`Status`]. Distinguished from [`StatusOld`] and [`StatusFull`] by the size of
    /// its data. Sent if [`selector`](Status::selector) is 2. Supported by [Model
    /// B](crate::devices::MODEL_B).
    ///
    /// The wire format also contains `model`: The model. Always 4711.
    ///
    /// The wire format also contains `selector`: The long layout. Always 2.
    ///
    /// Source: guide: Status.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct StatusLong {
        /// Faults.
        ///
        /// On the [Model A](crate::devices::MODEL_A): values of [`ModelAFaults`]. On the [Model
        /// B](crate::devices::MODEL_B): values of [`ModelBFaults`]. On the [Model
        /// C](crate::devices::MODEL_C): the values are unknown.
        pub flags: u32,
        /// Since start.
        ///
        /// Unit: s.
        pub uptime: u64,
    }
    wire 15 {
        [model: u16 = 4711]
        [selector: u8 = 2]
        [flags]
        [uptime]
    }
}

constructors! {
    StatusLong

    /// Creates it from its values.
    fn new(flags: u32, uptime: u64);
}

#[rustfmt::skip]
impl StatusLong {
    /// Reads `flags` as [`ModelAFaults`].
    ///
    /// On the [Model A](crate::devices::MODEL_A): values of [`ModelAFaults`].
    #[inline]
    #[must_use]
    pub fn flags_as_model_a_faults(&self) -> ModelAFaults {
        self.flags.into()
    }

    /// Reads `flags` as [`ModelBFaults`].
    ///
    /// On the [Model B](crate::devices::MODEL_B): values of [`ModelBFaults`].
    #[inline]
    #[must_use]
    pub fn flags_as_model_b_faults(&self) -> ModelBFaults {
        self.flags.into()
    }
}

field! {
    StatusLong: 0x90, "tools.status_long";
    in [0x01];
    constants [0: 18 103] [2: 2];
    sizes 15..=15;
    answers Status;
}

record! {
    /// Status response (0x01,0x90).
    ///
    /// The long layout of old devices. Its size tells it from the others.
    ///
    /// Response to [`Status`]. Distinguished from [`StatusLong`] and [`StatusFull`] by the size of
    /// its data. Sent if [`selector`](Status::selector) is 2. Supported by [Model
    /// A](crate::devices::MODEL_A).
    ///
    /// The wire format also contains `model`: The model. Always 4711.
    ///
    /// The wire format also contains `selector`: The long layout. Always 2.
    ///
    /// Source: guide: Status.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct StatusOld {
        /// Since start.
        ///
        /// Unit: s.
        pub uptime: u32,
    }
    wire 7 {
        [model: u16 = 4711]
        [selector: u8 = 2]
        [uptime]
    }
}

constructors! {
    StatusOld

    /// Creates it from its values.
    fn new(uptime: u32);
}

field! {
    StatusOld: 0x90, "tools.status_old";
    in [0x01];
    constants [0: 18 103] [2: 2];
    sizes 0..=14;
    answers Status;
}

record! {
    /// Status response (0x01,0x90).
    ///
    /// Response to [`Status`]. Distinguished from [`StatusLong`] and [`StatusOld`] by the size of
    /// its data. Sent if [`selector`](Status::selector) is 2. Supported by [Model
    /// C](crate::devices::MODEL_C).
    ///
    /// The wire format also contains `model`: The model. Always 4711.
    ///
    /// The wire format also contains `selector`: The long layout. Always 2.
    ///
    /// Source: guide: Status.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct StatusFull {
        /// Where it is.
        pub place: types::Point,
        /// Since start.
        ///
        /// Unit: s.
        pub uptime: u64,
        /// What it does.
        pub mode: types::Mode,
    }
    wire 16 {
        [model: u16 = 4711]
        [selector: u8 = 2]
        [place]
        [uptime]
        [mode]
    }
}

constructors! {
    StatusFull

    /// Creates it from its values.
    fn new(
        place: types::Point,
        uptime: u64,
        mode: types::Mode,
    );
}

field! {
    StatusFull: 0x90, "tools.status_full";
    in [0x01];
    constants [0: 18 103] [2: 2];
    sizes 16..=usize::MAX;
    answers Status;
}

record! {
    /// Bias response (0x01,0x9B).
    ///
    /// Response to [`Bias`] and [`CaptureBias`]. Supported by [Model A](crate::devices::MODEL_A)
    /// and [Model C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Bias; leaflet: Bias.
    #[derive(Copy, Default)]
    pub struct BiasVector {
        /// Taken off the measurement.
        ///
        /// Elements: x, y, z. Unit: g. Frame: sensor.
        pub bias: types::Vector3f,
    }
}

view! {
    BiasVector
    bias: types::Vector3f, at 0;
}

constructors! {
    BiasVector

    /// Creates it from its values.
    fn new(bias: impl Into<types::Vector3f>);
}

field! {
    BiasVector: 0x9B, "tools.bias_vector";
    in [0x01];
    answers Bias CaptureBias;
}
