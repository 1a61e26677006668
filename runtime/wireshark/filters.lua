-- ---------------------------------------------------------------------------------------------------------- filters
-- The display filters: a field of Wireshark for every value, element and bit, `mip.<set>.<field>.<parameter>.<part>`.

local mip = Proto(NAME, TITLE)
local stream = Proto("mip_stream", TITLE .. ", chunks of a byte stream")

local registered = {}

local function filter(field)
  registered[#registered + 1] = field
  return field
end

local REASONS = { [0] = "no header", "incomplete packet", "descriptor set 0 or 255", "wrong checksum" }
local DIRECTIONS = { [0] = "unknown", "host to device", "device to host" }
local STATUS = { [0] = "wrong", "right" }

local own = {
  sync = filter(ProtoField.uint16(PREFIX .. ".sync", "Sync", base.HEX, nil, nil, "Start of a packet.")),
  length = filter(ProtoField.uint8(PREFIX .. ".length", "Payload length", base.DEC, nil, nil, "Bytes of all fields.")),
  fields = filter(ProtoField.uint8(PREFIX .. ".fields", "Number of fields", base.DEC)),
  direction = filter(ProtoField.uint8(PREFIX .. ".direction", "Direction", base.DEC, DIRECTIONS)),
  checksum = filter(ProtoField.uint16(PREFIX .. ".checksum", "Checksum", base.HEX)),
  expected = filter(ProtoField.uint16(PREFIX .. ".checksum.expected", "Right checksum", base.HEX)),
  status = filter(ProtoField.uint8(PREFIX .. ".checksum.status", "Checksum status", base.DEC, STATUS)),
  skipped = filter(ProtoField.bytes(PREFIX .. ".skipped", "Skipped", base.SPACE, "Bytes outside of packets.")),
  reason = filter(ProtoField.uint8(PREFIX .. ".skipped.reason", "Reason", base.DEC, REASONS)),
  field_length = filter(ProtoField.uint8(PREFIX .. ".field.length", "Length", base.DEC, nil, nil,
    "Bytes of the field, including the length and the descriptor.")),
  field_descriptor = filter(ProtoField.uint8(PREFIX .. ".field.descriptor", "Descriptor", base.HEX)),
  field_name = filter(ProtoField.string(PREFIX .. ".field.name", "Name", base.ASCII, "Name of the field: set.field.")),
  field_role = filter(ProtoField.string(PREFIX .. ".field.role", "Role", base.ASCII, "command, response or data.")),
  field_data = filter(ProtoField.bytes(PREFIX .. ".field.data", "Data", base.SPACE,
    "Data of a field that cannot be decoded.")),
  invalid = filter(ProtoField.string(PREFIX .. ".field.invalid", "Invalid", base.ASCII,
    "Name of a value that its flags do not mark as valid.")),
  trailing = filter(ProtoField.bytes(PREFIX .. ".field.trailing", "Left over", base.SPACE,
    "Bytes after the last known parameter.")),
  answer_in = filter(ProtoField.framenum(PREFIX .. ".answer_in", "Answer in", base.NONE, frametype.RESPONSE)),
  request_in = filter(ProtoField.framenum(PREFIX .. ".request_in", "Request in", base.NONE, frametype.REQUEST)),
  answer_time = filter(ProtoField.relative_time(PREFIX .. ".answer_time", "Time to answer",
    "Time from the request to the reply.")),
}

do
  local titles = {}
  for number, set in pairs(SETS) do
    titles[number] = set.title
  end
  own.set = filter(ProtoField.uint8(PREFIX .. ".set", "Descriptor set", base.HEX, titles))
end

local function finding(name, text, group, severity)
  return ProtoExpert.new(PREFIX .. ".expert." .. name, text, expert.group[group], expert.severity[severity])
end

local experts = {
  checksum = finding("checksum", "Wrong checksum", "CHECKSUM", "ERROR"),
  skipped = finding("skipped", "Bytes outside of packets", "UNDECODED", "NOTE"),
  field_length = finding("field_length", "Malformed field length", "MALFORMED", "ERROR"),
  truncated = finding("truncated", "Field is too short", "MALFORMED", "ERROR"),
  count = finding("count", "Count exceeds the data", "MALFORMED", "ERROR"),
  constant = finding("constant", "Constant has a wrong value", "MALFORMED", "ERROR"),
  trailing = finding("trailing", "Bytes after the last known parameter", "UNDECODED", "NOTE"),
  refused = finding("refused", "Command refused", "RESPONSE_CODE", "WARN"),
  unknown_set = finding("unknown_set", "Unknown descriptor set", "UNDECODED", "NOTE"),
  unknown_descriptor = finding("unknown_descriptor", "Unknown descriptor", "UNDECODED", "NOTE"),
}

-- Returns the filter name of a part. A parameter with the name of its field does not repeat it.
local function inner(path, name)
  local set_field = path:match("^[^.]+%.[^.]+%.([^.]+)$")
  return set_field == name and path or path .. "." .. name
end

local NUMBERS = {
  u8 = "uint8", u16 = "uint16", u32 = "uint32", u64 = "uint64",
  s8 = "int8", s16 = "int16", s32 = "int32", s64 = "int64",
}
local SIZED = { "uint8", "uint16", "uint24", "uint32" }

-- The names of the values that Wireshark reads exactly; `tree` adds the others.
local function small(enum)
  local found
  for value, name in pairs(enum or {}) do
    if type(value) == "number" then
      found = found or {}
      found[value] = name
    end
  end
  return found
end

local function number_filter(path, name, type, enum, doc, hexadecimal)
  if type == "float" or type == "double" then
    return filter(ProtoField.new(name, path, ftypes[type:upper()], nil, base.NONE, nil, doc))
  elseif type == "bool" then
    return filter(ProtoField.bool(path, name, base.NONE, nil, nil, doc))
  elseif type == "char" then
    return filter(ProtoField.char(path, name, base.HEX, nil, nil, doc))
  end
  return filter(ProtoField[NUMBERS[type]](path, name, hexadecimal and base.HEX or base.DEC, small(enum), nil, doc))
end

-- The bits of a bitfield. A mask has at most 32 bits; longer numbers are computed.
local function bit_filters(flags, path)
  local found = {}
  for i, bits in ipairs(flags) do
    local name, doc = path .. "." .. bits.name, bits.doc
    if bits.little or bits.size > 4 then
      found[i] = filter(ProtoField.uint64(name, bits.name, base.DEC, small(bits.enum), nil, doc))
    elseif bits.width == 1 then
      found[i] = filter(ProtoField.bool(name, bits.name, 8 * bits.size, nil, bits.mask, doc))
    else
      found[i] = filter(ProtoField[SIZED[bits.size]](name, bits.name, base.DEC, bits.enum, bits.mask, doc))
    end
  end
  return found
end

local bind_rows

-- Binds a row to its filters: a structure has different filters in each field that contains it.
local bind = {}

local function bound(row, path)
  return bind[row.kind](row, path)
end

function bind.scalar(row, path)
  local at = inner(path, row.name or "")
  local made = number_filter(at, row.name, row.type, row.enum, row.doc, row.flags)
  return { row = row, filter = made, bits = row.flags and bit_filters(row.flags, at) }
end

function bind.constant(row, path)
  return { row = row, filter = number_filter(inner(path, row.name), row.name, row.type, nil, row.doc) }
end

bind.counter = bind.constant

function bind.bits(row, path)
  local at = inner(path, row.name)
  local whole = filter(ProtoField.bytes(at, row.name, base.NONE, row.doc))
  return { row = row, filter = whole, bits = bit_filters(row.flags, at) }
end

function bind.text(row, path)
  return { row = row, filter = filter(ProtoField.string(inner(path, row.name), row.name, base.ASCII, row.doc)) }
end

function bind.struct(row, path)
  local at = inner(path, row.name)
  return { row = row, filter = filter(ProtoField.none(at, row.name, row.doc)), body = bind_rows(row.record, at) }
end

-- Each element of a vector has its own filter; the elements of other arrays share one.
function bind.array(row, path)
  local at, item = inner(path, row.name), row.item
  if row.elements then
    local elements = {}
    for i, name in ipairs(row.elements) do
      local units = row.units and { row.units[i] or row.units[1] }
      elements[i] = {
        row = setmetatable({ units = units }, { __index = item }),
        filter = number_filter(at .. "." .. name, name, item.type, nil, row.doc),
      }
    end
    return { row = row, filter = filter(ProtoField.none(at, row.name, row.doc)), elements = elements }
  end
  local readings = {}
  for _, r in ipairs(row.readings or {}) do
    if not r.flags or r.member then -- bits belong to the whole array
      readings[#readings + 1] = r
    end
  end
  local about = { name = row.name, doc = row.doc, units = row.units, readings = readings }
  local named = setmetatable(about, { __index = item })
  return { row = row, item = bound(named, path) }
end

function bind.switch(row, path)
  local at, cases, members = inner(path, row.name), {}, {}
  for value, case in pairs(row.cases) do
    local item = case.item
    if item then
      members[item.name] = members[item.name] or bound(item, at)
    end
    cases[value] = { label = case.label, item = item and members[item.name] }
  end
  return { row = row, filter = filter(ProtoField.none(at, row.name, row.doc)), cases = cases }
end

function bind.group(row, path)
  return { row = row, body = bind_rows(row.body, path) }
end

function bind_rows(rows, path)
  local found = {}
  for i, row in ipairs(rows) do
    found[i] = bound(row, path)
  end
  return found
end

local function bind_field(f)
  local path = PREFIX .. "." .. f.name
  f.body = bind_rows(f.rows, path)
  if not f.plain then -- otherwise a value has this name
    f.filter = filter(ProtoField.none(path, f.title, f.doc))
  end
end
