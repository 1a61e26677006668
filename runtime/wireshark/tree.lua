-- ------------------------------------------------------------------------------------------------------------- tree
-- Adds the nodes of a field to Wireshark's tree.

local preferences = mip.prefs

-- Returns the unit of a value, or of an element of it; in a reading, it may be another one.
local function unit(row, read_as, index)
  local units = read_as and read_as.units or row.units
  local found = units and units[index or 1] or ""
  return found ~= "" and " " .. found or ""
end

-- Returns the text of a number, for the line of its vector or field.
local function written(made, range)
  local row = made.row
  if row.type == "float" then
    return string.format("%.6g", range:float())
  elseif row.type == "double" then
    return string.format("%.15g", range:float())
  elseif row.enum then
    return row.enum[made.value] or tostring(range:uint64())
  elseif row.type:sub(1, 1) == "s" then
    return tostring(range:int64())
  end
  return tostring(range:uint64())
end

-- Models that devices have named: conversation -> the id, or false if there are several.
local named

local function forget_devices()
  named = {}
end

-- Notes the model number with which a text begins.
local function device_named(conversation, text)
  local digits = text:match("^ *(%d+)[-. %z]") or text:match("^ *(%d+)$")
  for _, device in ipairs(digits and DEVICES or {}) do
    if device.number == tonumber(digits) then
      local before = named[conversation]
      named[conversation] = (before == nil or before == device.id) and device.id
    end
  end
end

-- Returns the id of the device in the preferences, or of the one that has named itself.
local function device_in(conversation)
  local device = DEVICES[preferences.device]
  return device and device.id or named[conversation] or nil
end

-- Returns the type that names the values of a plain number, or the units, by another parameter or the device.
local function reading(readings, record, member, device)
  for _, r in ipairs(readings or {}) do
    if r.member == member then
      if (r.by and record[r.by] == r.value) or (device and device == r.device) then
        return r
      end
    end
  end
end

local function bits_number(bits, part)
  local number = bits.little and part:le_uint64() or part:uint64()
  return number:lshift(64 - bits.shift - bits.width):rshift(64 - bits.width)
end

-- Returns a number in the form in which `decode` reads it.
local function key(number)
  local high, low = number:higher(), number:lower()
  return high < 2 ^ 21 and number:tonumber() or Struct.pack(">I4I4", high, low)
end

-- Writes the name of a large value as Wireshark writes those of others.
local function name_large(item, of, value, number)
  if type(value) == "string" and of.enum and of.enum[value] then
    item:set_text(string.format("%s: %s (%s)", of.name, of.enum[value], tostring(number)))
  end
end

-- Adds the bits of a device-specific type, which have no filters of their own.
local function bit_lines(flags, item, range)
  for _, bits in ipairs(flags) do
    if bits.at + bits.size <= range:len() then
      local part = range:range(bits.at, bits.size)
      local number = bits_number(bits, part)
      local value = key(number)
      local plain = bits.width == 1 and tostring(value == 1) or tostring(number)
      item:add(part, string.format("%s: %s", bits.name, bits.enum and bits.enum[value] or plain))
    end
  end
end

-- Adds bits with filters.
local function bit_items(made, item, range)
  for i, bits in ipairs(made.row.flags) do
    local part, field = range:range(bits.at, bits.size), made.bound.bits[i]
    if bits.little or bits.size > 4 then
      local number = bits_number(bits, part)
      name_large(item:add(field, part, number), bits, key(number), number)
    else
      item:add(field, part)
    end
  end
end

-- Returns the bytes of a node as a range of the packet, because Wireshark rejects an empty range of another range.
local function span(made, context)
  return context.data:range(context.base + made.at, made.size)
end

local add = {}

local function mark_invalid(item, name)
  item:append_text(" (invalid)")
  item:add(own.invalid, name):set_generated()
end

-- Adds a node; returns its text for the line of the field.
local function add_one(made, context)
  local text, item = add[made.row.kind](made, context)
  if not item or is_valid(made.row, context.record, context.device) then
    return text
  end
  mark_invalid(item, made.row.name)
  return text and text .. " (invalid)"
end

-- `context`: the packet, the offset of the field's data in it, the tree, the numbers of the record, and the readings
-- that an outer record has for its members.
local function within(context, tree, record, readings)
  return {
    data = context.data, base = context.base,
    tree = tree, record = record, readings = readings, outer = context.record, device = context.device,
  }
end

function add.scalar(made, context)
  local row, range = made.row, span(made, context)
  local item = context.tree:add(made.bound.filter, range)
  name_large(item, row, made.value, range:uint64())
  local read_as = reading(row.readings, context.record, nil, context.device)
    or reading(context.readings, context.outer, row.name, context.device)
  item:append_text(unit(row, read_as))
  if read_as and read_as.enum then
    local name = read_as.enum[made.value]
    item:append_text(name and " (" .. name .. ")" or "")
  elseif read_as and read_as.flags then
    bit_lines(read_as.flags, item, range)
  end
  if made.bound.bits and not (read_as and read_as.flags) then
    bit_items(made, item, range)
  end
  return written(made, range) .. unit(row, read_as), item
end

function add.constant(made, context)
  local item = context.tree:add(made.bound.filter, span(made, context))
  item:append_text(" (constant)")
  if made.wrong then
    item:add_proto_expert_info(experts.constant)
  end
end

function add.counter(made, context)
  context.tree:add(made.bound.filter, span(made, context))
end

function add.bits(made, context)
  local range = span(made, context)
  bit_items(made, context.tree:add(made.bound.filter, range), range)
  return tostring(range:bytes())
end

function add.text(made, context)
  local range = span(made, context)
  if made.size == 0 then
    context.tree:add(made.bound.filter, range, "")
    return '""'
  end
  context.tree:add_packet_field(made.bound.filter, range, ENC_ISO_8859_1)
  return '"' .. range:raw():match("^[%g ]*"):gsub(" +$", "") .. '"'
end

function add.struct(made, context)
  local item = context.tree:add(made.bound.filter, span(made, context))
  item:set_text(made.row.name)
  local inside = within(context, item, made.record, made.row.readings)
  for _, part in ipairs(made.parts) do
    add_one(part, inside)
  end
end

function add.array(made, context)
  local row, range = made.row, span(made, context)
  if row.elements then
    local item, texts = context.tree:add(made.bound.filter, range), {}
    local read_as = reading(row.readings, context.record, nil, context.device)
    local units = read_as and read_as.units or row.units
    local several = units and units[2]
    for i, part in ipairs(made.parts) do
      local _, element = add.scalar(part, within(context, item, {}))
      texts[i] = written(part, span(part, context)) .. (several and unit(row, read_as, i) or "")
      if not is_valid(row, context.record, context.device, i) then
        element:append_text(" (invalid)")
      end
    end
    local common = several and "" or unit(row, read_as)
    local text = table.concat(texts, ", ") .. common
    item:set_text(row.name .. ": " .. text)
    return text, item
  end
  local count = #made.parts
  local noun = count == 1 and "element" or "elements"
  local item = context.tree:add(range, string.format("%s: %d %s", row.name, count, noun))
  local read_as = reading(row.readings, context.record, nil, context.device)
  if read_as and read_as.flags then
    bit_lines(read_as.flags, item, range)
  end
  local inside = within(context, item, context.record)
  for _, part in ipairs(made.parts) do
    add_one(part, inside)
  end
  return count > 0 and string.format("%d %s", count, row.name) or nil, item
end

function add.switch(made, context)
  local item = context.tree:add(made.bound.filter, span(made, context))
  local case = made.case
  item:set_text(string.format("%s: %s", made.row.name, case and "case " .. case.label or "no case"))
  local inside = within(context, item, {})
  for _, part in ipairs(made.parts) do
    add_one(part, inside)
  end
end

-- Adds all nodes; returns the first values as a text for the line of the field.
local function add_nodes(nodes, data, base, tree, record, device)
  local texts, size = {}, 0
  local context = { data = data, base = base, tree = tree, record = record, device = device }
  for _, made in ipairs(nodes) do
    local text = add_one(made, context)
    if text and made.row.name ~= "function" and size < 80 then
      texts[#texts + 1] = text
      size = size + #text
    end
  end
  return table.concat(texts, "; ")
end
