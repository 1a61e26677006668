-- ------------------------------------------------------------------------------------------------------------ files
-- Opens a log of raw bytes as a capture: one frame for each packet, and one for the bytes between two packets.

local LONGEST = 255 + AROUND -- the maximum size of a packet in bytes
local PROBE = 65536 -- bytes at the start of a log that must contain a packet
local LUMP = 4096 -- the maximum size of a frame between packets in bytes

-- The tags before an exported PDU: the name of its dissector, and the end of the tags.
local EXPORTED = "\0\12\0" .. string.char(#NAME) .. NAME .. "\0\0\0\0"

-- Returns the bytes of the next frame; nil at the end of the file. They depend only on the bytes that follow.
local function next_bytes(file)
  local from = file:seek("cur")
  local raw = file:read(LONGEST)
  if not raw or #raw == 0 then
    return nil
  end
  local first = scan(raw, #raw < LONGEST, 1)[1]
  if not first or first.at > 0 then
    raw = raw .. (file:read(LUMP - LONGEST) or "")
    local packets, rest = scan(raw, #raw < LUMP, 1)
    first = packets[1] and { at = 0, size = packets[1].at } or { at = 0, size = rest or #raw }
  end
  file:seek("set", from + first.size)
  return raw:sub(1, first.size)
end

local log = FileHandler.new("MIP log", "mip", "Raw bytes of MIP packets", "rs")
log.extensions = "mip;bin;log;dat;raw"

function log.read_open(file, capture)
  if not recognized(file:read(PROBE) or "") then
    return false
  end
  file:seek("set", 0)
  capture.encap = wtap_encaps.WIRESHARK_UPPER_PDU
  capture.snapshot_length = 0
  return true
end

local function put(frame, bytes)
  local data = EXPORTED .. bytes
  frame.data, frame.captured_length, frame.original_length = data, #data, #data
  frame.encap, frame.flags = wtap_encaps.WIRESHARK_UPPER_PDU, wtap_presence_flags.CAP_LEN
end

function log.read(file, _, frame)
  local at = file:seek("cur")
  local bytes = next_bytes(file)
  if not bytes then
    return false
  end
  put(frame, bytes)
  return at
end

function log.seek_read(file, _, frame, at)
  file:seek("set", at)
  local bytes = next_bytes(file)
  if not bytes then
    return false
  end
  put(frame, bytes)
  return true
end

register_filehandler(log)
