-- ----------------------------------------------------------------------------------------------------------- decode
-- Reads the data of a field into nodes, as its rows describe; this part is independent of Wireshark. A node is
--   { row, at, size, value or text, parts }     at counts from 0 in the data of the field.

local function fail(kind, text)
  error({ kind = kind, text = text }, 0)
end

-- Reads an unsigned number, most significant byte first. One of more than 53 bits is a string of its bytes, because
-- numbers of Lua do not represent it exactly; the tables contain it in the same form.
local function unsigned(raw, at, size)
  local value = 0
  for i = at + 1, at + size do
    if value >= 2 ^ 45 then
      return raw:sub(at + 1, at + size)
    end
    value = value * 256 + raw:byte(i)
  end
  return value
end

-- Writes an integer as text, without a decimal point in any version of Lua.
local function whole(value)
  return type(value) == "number" and string.format("%.0f", value) or "?"
end

local function take(reader, size)
  local at = reader.at
  if size > reader.stop - at then
    local short = size - (reader.stop - at)
    fail("truncated", string.format("%d %s missing", short, short == 1 and "byte is" or "bytes are"))
  end
  reader.at = at + size
  return at
end

-- Returns the number of items of an array; each has `size` bytes.
local function length(row, size, reader, record)
  local left = reader.stop - reader.at
  if row.count then
    return row.count
  elseif not row.counter then
    return math.min(math.floor(left / size), row.capacity)
  end
  local count = record[row.counter]
  if type(count) ~= "number" or count * size > left then
    fail("count", string.format("%s is %s, but %d bytes follow", row.counter, whole(count), left))
  elseif count > row.capacity then
    fail("count", string.format("%s is %s, but a field holds %d", row.counter, whole(count), row.capacity))
  end
  return count
end

local read = {}

-- Reads one bound row, adds its node to `nodes` and its number to `record`.
local function read_one(b, reader, record, nodes)
  return read[b.row.kind](b, reader, record, nodes)
end

local function read_all(body, reader, record, nodes)
  for _, b in ipairs(body) do
    read_one(b, reader, record, nodes)
  end
end

local function node(b, at, nodes)
  local made = { bound = b, row = b.row, at = at, size = 0 }
  nodes[#nodes + 1] = made
  return made
end

function read.scalar(b, reader, record, nodes)
  local at = take(reader, b.row.size)
  local made = node(b, at, nodes)
  made.size = b.row.size
  made.value = unsigned(reader.raw, at, b.row.size)
  if b.row.name then
    record[b.row.name] = made.value
  end
end

read.counter = read.scalar

function read.constant(b, reader, record, nodes)
  read.scalar(b, reader, record, nodes)
  local row, found = b.row, nodes[#nodes]
  if reader.raw:sub(found.at + 1, found.at + found.size) ~= row.value then
    found.wrong = true
    local right = whole(unsigned(row.value, 0, #row.value))
    fail("constant", string.format("%s is %s, not %s", row.name, whole(found.value), right))
  end
end

function read.bits(b, reader, _, nodes)
  local at = take(reader, b.row.size)
  node(b, at, nodes).size = b.row.size
end

function read.text(b, reader, record, nodes)
  local count = length(b.row, 1, reader, record)
  local at = take(reader, count)
  node(b, at, nodes).size = count
end

function read.struct(b, reader, _, nodes)
  local made = node(b, reader.at, nodes)
  made.parts, made.record = {}, {}
  read_all(b.body, reader, made.record, made.parts)
  made.size = reader.at - made.at
end

function read.array(b, reader, record, nodes)
  local count = length(b.row, b.row.size, reader, record)
  local made = node(b, reader.at, nodes)
  made.parts = {}
  for i = 1, count do
    read_one(b.elements and b.elements[i] or b.item, reader, {}, made.parts)
  end
  made.size = reader.at - made.at
end

function read.switch(b, reader, record, nodes)
  local made = node(b, reader.at, nodes)
  local case = b.cases[record[b.row.tag] or ""]
  made.parts, made.case = {}, case
  if case and case.item then
    read_one(case.item, reader, {}, made.parts)
  end
  made.size = reader.at - made.at
end

-- Reads parameters that are present together or not at all; returns true if they are present.
local function read_group(b, required, reader, record, nodes)
  local row = b.row
  local mark, least = reader.at, row.last <= required
  if not least and mark == reader.stop then
    return false
  end
  local found, numbers = {}, setmetatable({}, { __index = record })
  local good, problem = pcall(read_all, b.body, reader, numbers, found)
  if good and not least and reader.at == mark then
    return false -- an empty union
  elseif not good and not least and type(problem) == "table" and problem.kind == "truncated" then
    reader.at = mark
    return false
  end
  for _, made in ipairs(found) do
    nodes[#nodes + 1] = made
  end
  for name, value in pairs(numbers) do
    record[name] = value
  end
  if not good then
    error(problem, 0)
  end
  return true
end

local function read_field(f, reader, record, nodes)
  local required = f.always or 0
  for _, b in ipairs(f.body) do
    if b.row.kind == "group" then
      if b.row.first == 1 and f.required then
        required = f.required[record["function"]] or 0
      end
      if not read_group(b, required, reader, record, nodes) then
        return
      end
    else
      read_one(b, reader, record, nodes)
    end
  end
end

-- Decodes a field. Returns its nodes, the numbers of its parameters, the number of bytes left over, and the problem:
-- { kind = "truncated", "count" or "constant", text = ... }.
local function decode(f, raw)
  local reader, record, nodes = { raw = raw, at = 0, stop = #raw }, {}, {}
  local good, problem = pcall(read_field, f, reader, record, nodes)
  if not good and type(problem) ~= "table" then
    error(problem, 0)
  end
  return nodes, record, reader.stop - reader.at, not good and problem or nil
end

local function overlap(number, mask)
  return UInt64(number):band(UInt64(mask)):tonumber() ~= 0
end

-- True if the bits of a mask are set in a number; the mask 0 is for a Boolean.
local function holds(number, mask)
  if type(number) ~= "number" then
    return number ~= nil
  end
  return mask == 0 and number ~= 0 or UInt64(number):band(UInt64(mask)):tonumber() == mask
end

-- Returns the flags that mark a value as valid: of a device, by its id, or if it is not known, those that the flags of
-- the record fit. Others are the last.
local function flags_of(readings, record, device)
  for _, r in ipairs(readings) do
    local flag = r.flags[1]
    local number = flag and record[flag.name]
    if not r.devices or (device and r.devices[device]) then
      return r.flags
    elseif not device and r.fewer and type(number) == "number" and not overlap(number, r.fewer) then
      return r.flags
    end
  end
end

-- True if all flags mark a value as valid; with an index, those of this element.
local function is_valid(row, record, device, index)
  local flags = row.valid and flags_of(row.valid, record, device) or {}
  for i, flag in ipairs(flags) do
    if (not index or not flags[2] or i == index) and not holds(record[flag.name], flag.mask) then
      return false
    end
  end
  return true
end

-- True if the data contains the constants of a layout, as far as the data reaches.
local function fits(f, raw)
  for _, constant in ipairs(f.constants or {}) do
    local found = raw:sub(constant.at + 1, constant.at + #constant.value)
    if constant.value:sub(1, #found) ~= found then
      return false
    end
  end
  return true
end

-- Chooses a layout for data: of those whose constants match, the longest that fits into the data, else the shortest.
local function choose(candidates, raw)
  if not candidates or #candidates < 2 then
    return candidates and candidates[1]
  end
  local held, short
  for _, f in ipairs(candidates) do
    if fits(f, raw) then
      if f.least <= #raw then
        held = (not held or f.least > held.least) and f or held
      else
        short = (not short or f.least < short.least) and f or short
      end
    end
  end
  return held or short
end

-- Returns the layouts that a descriptor may have in a packet of a set.
local function layouts(number, descriptor)
  if number < 0x80 and descriptor == ACKNOWLEDGE then
    return { ACKNOWLEDGE_FIELD }
  end
  local set = SETS[number]
  local found = set and set.fields[descriptor]
  if not found and number >= 0x80 and SETS[SHARED] then
    found = SETS[SHARED].fields[descriptor]
  end
  return found
end
