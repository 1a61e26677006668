-- ---------------------------------------------------------------------------------------------------------- packets
-- Finds packets in bytes, and shows them.

local HEADER, AROUND = 4, 6 -- bytes of the header, and of header and checksum

local function checksum(raw, at, size)
  local bytes, a, b = { raw:byte(at + 1, at + size) }, 0, 0
  for i = 1, size do
    a = a + bytes[i]
    b = b + a
  end
  return a % 256 * 256 + b % 256
end

-- Returns the size of the packet whose sync is at `at`, with its checksum; nil if the header is incomplete.
local function packet_size(raw, at)
  return #raw >= at + HEADER and raw:byte(at + 4) + AROUND or nil
end

local function intact(raw, at, size)
  return checksum(raw, at, size - 2) == raw:byte(at + size - 1) * 256 + raw:byte(at + size)
end

-- No packet has set 0 or 0xFF: they represent the fields of every command set and of every data set.
local function is_set(number)
  return number ~= 0 and number ~= SHARED
end

local recognized

-- Finds packets, at most `limit`. Returns the start and size of each, and the start of a packet that may continue in
-- later bytes; `final` means that no bytes follow. After a header without a packet, the search continues one byte after
-- its sync. A header is without a packet, too, if one begins in the bytes that it claims: the stream may end with them.
local function scan(raw, final, limit)
  local found, at = {}, 0
  while at < #raw and #found ~= limit do
    local sync = raw:find(SYNC, at + 1, true)
    if not sync then
      local half = not final and raw:sub(-1) == SYNC:sub(1, 1) and #raw - 1 >= at
      return found, half and #raw - 1 or nil
    end
    at = sync - 1
    local size = packet_size(raw, at)
    if #raw > at + 2 and not is_set(raw:byte(at + 3)) then
      at = at + 1
    elseif not size or at + size > #raw then
      if not final and not recognized(raw:sub(at + 2)) then
        return found, at
      end
      at = at + 1
    elseif intact(raw, at, size) then
      found[#found + 1] = { at = at, size = size }
      at = at + size
    else
      at = at + 1
    end
  end
  return found
end

-- True if the fields fill the payload exactly and the set is known.
local function plausible(raw, at, size)
  local field, stop = at + HEADER, at + size - 2
  while field < stop do
    local length = raw:byte(field + 1)
    if length < 2 or field + length > stop then
      return false
    end
    field = field + length
  end
  return SETS[raw:byte(at + 3)] ~= nil
end

-- True if one of the packets in these bytes is plausible. The first may be of an unknown set, or a chance match.
function recognized(raw)
  for _, found in ipairs((scan(raw, true))) do
    if plausible(raw, found.at, found.size) then
      return true
    end
  end
  return false
end

-- Divides bytes between packets into pieces: { at, size, reason }, or { at, size, broken = true } for a packet whose
-- checksum alone is wrong.
local function pieces(raw, at, stop)
  local found = {}
  while at < stop do
    local piece = { at = at, reason = 0 }
    local sync = raw:find(SYNC, at + 1, true)
    if sync and sync - 1 == at and sync < stop then
      local size = packet_size(raw, at)
      if #raw > at + 2 and not is_set(raw:byte(at + 3)) then
        piece.reason = 2
      elseif not size or at + size > #raw then
        piece.reason = 1
      else
        piece.reason = 3
        piece.broken = at + size <= stop and plausible(raw, at, size)
        piece.size = piece.broken and size or nil
      end
      sync = raw:find(SYNC, at + 2, true)
    end
    local last = sync and sync - 1 < stop and sync - 1 or stop
    piece.size = piece.size or last - at
    found[#found + 1] = piece
    at = at + piece.size
  end
  return found
end

local function shown_bytes(data)
  local text = data:match("^%s*([%g ]+)%s*$")
  return text and ": " .. text or ""
end

local function show_skipped(piece, data, tree)
  local range = data:range(piece.at, piece.size)
  local item = tree:add(own.skipped, range)
  local noun = piece.size == 1 and "byte" or "bytes"
  item:set_text(string.format("Skipped: %d %s%s", piece.size, noun, shown_bytes(range:raw())))
  item:add(own.reason, piece.reason):set_generated()
  item:add_proto_expert_info(experts.skipped)
end

-- Shows the bytes of a field that cannot be decoded.
local function show_raw(item, range)
  item:add(own.field_data, range)
end

local function command_title(number, descriptor)
  local set = SETS[number]
  local found = set and set.fields[descriptor]
  if found then
    return found[1].title
  end
  return set and set.named[descriptor] or string.format("0x%02X", descriptor)
end

local show = {} -- role -> function that shows more of a field than its values, and returns its text for the info column

function show.command(f, packet, item, record, key)
  if packet.good then
    local exchange =
      command_sent(key, packet.conversation, packet.set, f.descriptor, f, record, packet.frame, packet.time)
    show_request(exchange, item)
  end
  local selected = f.required and E["function_selector"][record["function"]]
  return f.title .. (selected and " (" .. selected .. ")" or "")
end

function show.response(f, packet, item)
  if packet.exchange then
    show_answer(packet.exchange, item)
  end
  return f.title
end

function show.data(f)
  return f.title
end

local function show_acknowledge(packet, item, record, key)
  local title, code = command_title(packet.set, record.command), record.code
  local name = E["ack_code"][code] or whole(code)
  packet.exchange = packet.good
    and answer_came(key, packet.conversation, packet.set, record.command, packet.frame, packet.time)
  if packet.exchange then
    show_answer(packet.exchange, item)
  end
  item:append_text(string.format(" of %s: %s", title, name))
  if code ~= 0 then
    item:add_proto_expert_info(experts.refused, string.format("%s refused: %s", title, name))
  end
  return title .. (code == 0 and " acknowledged" or " refused: " .. name)
end

local PROBLEMS = { truncated = "too short", count = "wrong count", constant = "wrong constant" }

-- Notes the model of a device that identifies itself.
local function model_numbers(nodes, raw, conversation)
  for _, made in ipairs(nodes) do
    if MODEL_NUMBERS[made.row.name] then
      device_named(conversation, raw:sub(made.at + 1, made.at + made.size))
    end
    model_numbers(made.parts or {}, raw, conversation)
  end
end

-- Shows one field; returns its text for the info column, and its layout.
local function show_field(packet, at, size, index, tree)
  local data, descriptor = packet.data:range(at + 2, size - 2), packet.raw:byte(at + 2)
  local raw = packet.raw:sub(at + 3, at + size)
  local key = packet.key .. ":" .. index
  local f = choose(layouts(packet.set, descriptor), raw)
  local range, title = packet.data:range(at, size), f and f.title or command_title(packet.set, descriptor)
  local item = f and f.filter and tree:add(f.filter, range) or tree:add(range, "")
  item:set_text(string.format("%s (0x%02X,0x%02X)", title, packet.set, descriptor))
  item:add(own.field_length, packet.data:range(at, 1))
  item:add(own.field_descriptor, packet.data:range(at + 1, 1))
  if not f then
    show_raw(item, data)
    item:add_proto_expert_info(experts.unknown_descriptor)
    packet.exchange = nil
    return SETS[packet.set] and SETS[packet.set].named[descriptor] or title
  end
  add_generated(item, own.field_name, f.name)
  add_generated(item, own.field_role, f.role)
  local nodes, record, left, problem = decode(f, raw)
  if f.name == IDENTITY and packet.good then
    model_numbers(nodes, raw, packet.conversation)
  end
  local text = add_nodes(nodes, packet.data, at + 2, item, record, device_in(packet.conversation))
  if problem then
    if problem.kind ~= "constant" then -- a wrong constant is shown at its value
      item:add_proto_expert_info(experts[problem.kind], problem.text)
    end
    show_raw(item, data)
    packet.exchange = nil
    return f.title .. " (" .. PROBLEMS[problem.kind] .. ")", f
  end
  if left > 0 then
    item:add(own.trailing, packet.data:range(at + size - left, left)):add_proto_expert_info(experts.trailing)
  end
  if f == ACKNOWLEDGE_FIELD then
    return show_acknowledge(packet, item, record, key), f
  end
  item:append_text(text ~= "" and ": " .. text or "")
  local said = show[f.role](f, packet, item, record, key)
  packet.exchange = nil -- only the field after an acknowledge is its response
  return said, f
end

-- Returns the direction: 1 if the host sent it, 2 if the device did.
local function direction_of(f)
  return f.role == "command" and not f.from_device and 1 or 2
end

-- Shows the fields of a packet; returns their texts, and their direction.
local function show_fields(packet, tree)
  local texts, direction, index = {}, 0, 0
  local at, stop = packet.at + HEADER, packet.at + packet.size - 2
  while at < stop do
    local size = packet.raw:byte(at + 1)
    if size < 2 or at + size > stop then
      local item = tree:add(own.field_length, packet.data:range(at, 1))
      local text = string.format("A field of length %d in %d bytes", size, stop - at)
      item:add_proto_expert_info(experts.field_length, text)
      item:add(own.field_data, packet.data:range(at, stop - at))
      texts[#texts + 1] = "malformed field"
      break
    end
    index = index + 1
    local text, f = show_field(packet, at, size, index, tree)
    texts[index] = text
    if f and direction == 0 then
      direction = direction_of(f)
    end
    at = at + size
  end
  return texts, direction, index
end

-- Shows a packet; returns its text for the info column, and its direction.
local function show_packet(packet, tree)
  local data, at, size = packet.data, packet.at, packet.size
  packet.set = packet.raw:byte(at + 3)
  packet.good = not packet.broken
  packet.key = string.format("%d:%d:%d:%d", packet.frame, #packet.raw, data:offset(), at)
  local set = SETS[packet.set]
  local title = set and set.title or string.format("Set 0x%02X", packet.set)
  local item = tree:add(mip, data:range(at, size))
  item:add(own.sync, data:range(at, 2))
  local number = item:add(own.set, data:range(at + 2, 1))
  if not set then
    number:add_proto_expert_info(experts.unknown_set)
  end
  item:add(own.length, data:range(at + 3, 1))
  local texts, direction, count = show_fields(packet, item)
  item:set_text(string.format("MIP, %s (0x%02X), %d %s", title, packet.set, count, count == 1 and "field" or "fields"))
  local sum, right = data:range(at + size - 2, 2), checksum(packet.raw, at, size - 2)
  local line = item:add(own.checksum, sum)
  line:append_text(packet.good and " (right)" or string.format(" (wrong, should be 0x%04x)", right))
  line:add(own.status, packet.good and 1 or 0):set_generated()
  line:add(own.expected, right):set_generated()
  if not packet.good then
    line:add_proto_expert_info(experts.checksum, string.format("Wrong checksum, should be 0x%04x", right))
  end
  add_generated(item, own.fields, count)
  add_generated(item, own.direction, direction)
  local text = title .. (#texts > 0 and ": " .. table.concat(texts, ", ") or "")
  return packet.good and text or text .. " [wrong checksum]", direction
end
