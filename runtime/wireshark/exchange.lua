-- --------------------------------------------------------------------------------------------------------- exchange
-- Matches replies to commands. Wireshark passes packets in order once; the matches found then are used again whenever
-- it shows a packet again.

local WAIT = 2.0 -- seconds; a reply after this time is matched to a later command, if there is one
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
    queue[#queue + 1] = exchange
    if #queue > WAITING_AT_MOST then
      table.remove(queue, 1)
    end
  end
  return known[key]
end

-- Matches an acknowledge to the oldest command of this descriptor that may still wait, else to the newest.
local function answer_came(key, conversation, number, descriptor, frame, time)
  if not known[key] then
    local queue, found = waiting(conversation, number, descriptor), nil
    for i, exchange in ipairs(queue) do
      found = i
      if time - exchange.sent <= exchange.patience then
        break
      end
    end
    if found then
      local exchange = table.remove(queue, found)
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
