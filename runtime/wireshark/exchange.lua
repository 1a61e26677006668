-- --------------------------------------------------------------------------------------------------------- exchange
-- Matches replies to commands. Wireshark passes packets in order once; the matches found then are used again whenever
-- it shows a packet again.

-- Seconds in which a host may send commands with one descriptor before the first reply. One that it sends later, as a
-- poll, means that it has ceased to wait for the earlier ones; else, a lost reply would shift all later ones.
local WAIT = 0.1
local WAITING_AT_MOST = 16 -- the maximum number of waiting commands with one descriptor in a conversation

local exchanges -- conversation and descriptor -> commands that wait for a reply, in the order in which they were sent
local known -- field of a packet -> the exchange to which it belongs

local function forget_exchanges()
  exchanges, known = {}, {}
end

-- True if the device replies to this command.
local function answered(f, record)
  if f.silent and f.silent[record["function"]] then
    return false
  end
  for _, condition in ipairs(f.silent_when or {}) do
    if record[condition.name] ~= condition.value then
      return true
    end
  end
  return not (f.silent_when and #f.silent_when > 0)
end

local function waiting(conversation, number, descriptor)
  local place = string.format("%s %d %d", conversation, number, descriptor)
  exchanges[place] = exchanges[place] or {}
  return exchanges[place]
end

-- Notes that a command was sent; `key` identifies its field, and is the same whenever the packet is shown.
local function command_sent(key, conversation, number, descriptor, f, record, frame, time)
  if not known[key] and answered(f, record) then
    local exchange = { request = frame, sent = time, patience = math.max(WAIT, f.timeout or 0) }
    known[key] = exchange
    local queue = waiting(conversation, number, descriptor)
    while queue[1] and (#queue == WAITING_AT_MOST or time - queue[1].sent > queue[1].patience) do
      table.remove(queue, 1)
    end
    queue[#queue + 1] = exchange
  end
  return known[key]
end

-- Matches an acknowledge to the oldest command of this descriptor that still waits.
local function answer_came(key, conversation, number, descriptor, frame, time)
  if not known[key] then
    local exchange = table.remove(waiting(conversation, number, descriptor), 1)
    if exchange then
      exchange.answer, exchange.answered = frame, time
      known[key] = exchange
    end
  end
  return known[key]
end

local function add_generated(tree, field, value)
  tree:add(field, value):set_generated()
end

local function show_request(exchange, tree)
  if exchange and exchange.answer then
    add_generated(tree, own.answer_in, exchange.answer)
  end
end

local function show_answer(exchange, tree)
  if exchange then
    add_generated(tree, own.request_in, exchange.request)
    local past = math.floor(math.max(0, exchange.answered - exchange.sent) * 1e9 + 0.5)
    add_generated(tree, own.answer_time, NSTime(math.floor(past / 1000000000), past % 1000000000))
  end
end
