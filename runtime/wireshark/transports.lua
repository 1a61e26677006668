-- ------------------------------------------------------------------------------------------------------- transports
-- Bytes arrive in TCP segments, in datagrams, or in chunks of a serial line.

local interface = Field.new("frame.interface_id")

local function conversation_of(pinfo)
  local here, there = tostring(pinfo.src) .. ":" .. pinfo.src_port, tostring(pinfo.dst) .. ":" .. pinfo.dst_port
  local found = interface()
  local ports = here < there and here .. " " .. there or there .. " " .. here
  return string.format("%s %s %s", pinfo.port_type, ports, found and tostring(found.value) or "")
end

-- Shows all packets and skipped bytes from `from` to `stop`; returns the texts of the packets, and their direction.
local function show_bytes(data, raw, packets, from, stop, pinfo, tree)
  local texts, direction = {}, 0
  local conversation = conversation_of(pinfo)
  local function packet(at, size, broken)
    local text, way = show_packet({
      data = data, raw = raw, at = at, size = size, broken = broken,
      frame = pinfo.number, time = pinfo.rel_ts, conversation = conversation,
    }, tree)
    texts[#texts + 1] = text
    direction = direction == 0 and way or direction
  end
  local function gap(last)
    for _, piece in ipairs(pieces(raw, from, last)) do
      if piece.broken then
        packet(piece.at, piece.size, true)
      else
        show_skipped(piece, data, tree)
      end
    end
  end
  for _, found in ipairs(packets) do
    gap(found.at)
    packet(found.at, found.size)
    from = found.at + found.size
  end
  gap(stop)
  return texts, direction
end

local function show_columns(pinfo, texts)
  pinfo.cols.protocol = "MIP"
  local text = table.concat(texts, " | ")
  if pinfo.private["mip"] then -- an earlier chunk of this frame was shown
    pinfo.cols.info:append(#texts > 0 and " | " .. text or "")
  else
    pinfo.cols.info = text
    pinfo.private["mip"] = "1"
  end
end

local SIDES = { { "Host", "Device" }, { "Device", "Host" } }

local function show_sides(pinfo, direction)
  local sides = SIDES[direction]
  if sides and pinfo.port_type == 0 then
    pinfo.cols.src, pinfo.cols.dst = sides[1], sides[2]
  end
end

-- Dissects a datagram, or other bytes that are complete.
local function dissect_whole(tvb, pinfo, tree)
  local raw = tvb:raw()
  local texts, direction = show_bytes(tvb, raw, scan(raw, true), 0, #raw, pinfo, tree)
  show_columns(pinfo, #texts > 0 and texts or { "no packet" })
  show_sides(pinfo, direction)
  return tvb:len()
end

-- Dissects a chunk of a TCP stream or a serial line. Wireshark passes chunks in order once. The bytes held back before
-- each chunk are kept, so that it looks the same whenever Wireshark returns to it. Wireshark's own reassembly is for
-- packets of known length: it shows packets twice if a supposed header turns out not to be one when more bytes arrive.
local held -- line -> bytes held back after its latest chunk
local before -- line -> chunk -> bytes held back before the chunk

-- Returns the bytes held back before a chunk, and whether the chunk is new.
local function held_before(line, chunk)
  before[line] = before[line] or {}
  local known = before[line][chunk]
  before[line][chunk] = known or held[line] or ""
  return before[line][chunk], known == nil
end

local function dissect_chunk(tvb, pinfo, tree)
  local sender = string.format("%s:%d %s", tostring(pinfo.src), pinfo.src_port, tostring(pinfo.p2p_dir))
  local line = conversation_of(pinfo) .. " " .. sender
  local head, new = held_before(line, string.format("%d:%d:%d", pinfo.number, tvb:offset(), tvb:len()))
  local raw, data = head .. tvb:raw(), tvb
  if head ~= "" then
    data = ByteArray.new(raw, true):tvb("MIP, with the bytes of earlier frames")
  end
  local packets, rest = scan(raw, false)
  if new then -- during a capture, Wireshark may return to earlier chunks
    held[line] = rest and raw:sub(rest + 1) or ""
  end
  local texts, direction = show_bytes(data, raw, packets, 0, rest or #raw, pinfo, tree)
  if rest then
    local from = math.max(rest, #head)
    local item = tree:add(stream, data:range(from, #raw - from))
    local size = #raw - from
    local noun = size == 1 and "byte" or "bytes"
    item:set_text(string.format("MIP, %d %s of a packet that continues in a later frame", size, noun))
  end
  show_columns(pinfo, #texts > 0 and texts or { rest and "part of a packet" or "no packet" })
  show_sides(pinfo, direction)
  return tvb:len()
end

stream.dissector = dissect_chunk

local TCP = 2 -- pinfo.port_type

function mip.dissector(tvb, pinfo, tree)
  if tvb:len() == 0 then
    return 0
  end
  return (pinfo.port_type == TCP and dissect_chunk or dissect_whole)(tvb, pinfo, tree)
end

function mip.init()
  held, before = {}, {}
  forget_exchanges()
  forget_devices()
end

-- ------------------------------------------------------------------------- heuristics

-- True if this is MIP: a whole packet of a known set with the right checksum, or the start of one.
local function looks_like(raw)
  if recognized(raw) then
    return true
  end
  if #raw < AROUND or raw:sub(1, 2) ~= SYNC or not is_set(raw:byte(3)) or not SETS[raw:byte(3)] then
    return false
  end
  local length, first = raw:byte(4), raw:byte(5)
  return first >= 2 and first <= length and layouts(raw:byte(3), raw:byte(6)) ~= nil
end

local LOOK_AT = 4096 -- bytes

local function heuristic(tvb, pinfo, tree)
  if tvb:len() < AROUND or not looks_like(tvb:raw(0, math.min(tvb:len(), LOOK_AT))) then
    return false
  end
  pinfo.conversation = mip
  mip.dissector(tvb, pinfo, tree)
  return true
end

-- ------------------------------------------------------------------------- preferences

preferences.tcp_ports =
  Pref.range("TCP ports", "", "Ports whose streams are MIP. Other streams are recognized by their packets.", 65535)
preferences.udp_ports =
  Pref.range("UDP ports", "", "Ports whose datagrams are MIP. Other datagrams are recognized by their packets.", 65535)
preferences.user_dlts =
  Pref.range("User DLTs", "147", "Link types of serial captures: 147 (USER0) to 162 (USER15).", 162)

do
  local devices = { { 1, "as the capture says", 0 } }
  for i, device in ipairs(DEVICES) do
    devices[i + 1] = { i + 1, device.title, i }
  end
  preferences.device =
    Pref.enum("Device", 0, "Model as which values, bits and flags are read if they differ.", devices, false)
end
preferences.version = Pref.statictext("Version " .. VERSION, "")

-- Returns the numbers of a range such as "147,150-152".
local function numbers_of(text)
  local found = {}
  for first, last in text:gmatch("(%d+)%-?(%d*)") do
    for number = tonumber(first), tonumber(last) or tonumber(first) do
      found[#found + 1] = number
    end
  end
  return found
end

local FIRST_DLT, LAST_DLT = 147, 162
local chosen = {} -- what is registered: table -> text of the preference

local function register(name, text, change)
  if chosen[name] ~= text then
    for _, number in ipairs(numbers_of(chosen[name] or "")) do
      change("remove", number)
    end
    for _, number in ipairs(numbers_of(text)) do
      change("add", number)
    end
    chosen[name] = text
  end
end

local function apply_preferences()
  for _, name in ipairs({ "tcp", "udp" }) do
    local ports = DissectorTable.get(name .. ".port")
    register(name, preferences[name .. "_ports"], function(verb, number)
      ports[verb](ports, number, mip)
    end)
  end
  local links = DissectorTable.get("wtap_encap")
  register("dlt", preferences.user_dlts, function(verb, number)
    if number >= FIRST_DLT and number <= LAST_DLT then
      links[verb](links, wtap_encaps.USER0 + number - FIRST_DLT, stream)
    end
  end)
end

mip.prefs_changed = apply_preferences

-- ------------------------------------------------------------------------- registration

for _, set in pairs(SETS) do
  for _, candidates in pairs(set.fields) do
    for _, f in ipairs(candidates) do
      bind_field(f)
    end
  end
end
bind_field(ACKNOWLEDGE_FIELD)
mip.fields = registered
do
  local all = {}
  for _, found in pairs(experts) do
    all[#all + 1] = found
  end
  mip.experts = all
end

DissectorTable.get("tcp.port"):add_for_decode_as(mip)
DissectorTable.get("udp.port"):add_for_decode_as(mip)
mip:register_heuristic("tcp", heuristic)
mip:register_heuristic("udp", heuristic)
apply_preferences()
