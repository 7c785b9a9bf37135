-- Progress of running cases: refreshed in place on a terminal, now and then elsewhere.
local engine = require "stiction.engine"

local progress = {}

local between_refreshes, between_lines = 0.2, 10 -- s
local most_jobs = 8 -- that a terminal shows a line of
local few = { terminal = 20, other = 200 } -- cases of which each is told

local scales = { { 1, "s" }, { 1e-3, "ms" }, { 1e-6, "us" }, { 1e-9, "ns" } }

local function scale_of(time)
  for _, scale in ipairs(scales) do
    if math.abs(time) >= scale[1] then
      return scale[1], scale[2]
    end
  end
  return 1, "s"
end

--- "75 s", "3 min 05 s", "2 h 10 min"
function progress.duration(seconds)
  if seconds < 10 then
    return ("%.1f s"):format(seconds)
  end
  seconds = math.floor(seconds + 0.5)
  if seconds < 60 then
    return ("%d s"):format(seconds)
  elseif seconds < 3600 then
    return ("%d min %02d s"):format(seconds // 60, seconds % 60)
  end
  return ("%d h %02d min"):format(seconds // 3600, seconds % 3600 // 60)
end

--- One line on where a case stands.
function progress.line(id, p)
  local factor, unit = scale_of(p.end_time)
  return ("%s  t %.4g/%.4g %s  step %d  dt %.3g %s  it %d  open %d stick %d slip %d  left %s"):format(id,
    p.time / factor, p.end_time / factor, unit, p.step, p.dt / factor, unit, p.iterations, p.open, p.stick, p.slip,
    progress.duration(p.seconds_left))
end

--- One line on where a sweep stands, of {total =, done =, failed =, began =}.
function progress.sweep_line(tally, running, now)
  local rate = tally.done / math.max(now - tally.began, 1e-3)
  local left = rate > 0 and "  left " .. progress.duration((tally.total - tally.done) / rate) or ""
  return ("%d of %d cases done, %d failed, %d running  %.3g/min%s"):format(tally.done, tally.total, tally.failed, running,
    60 * rate, left)
end

local Display = {}
Display.__index = Display

local function erase(display)
  if display.shown > 0 then
    engine.write(("\27[%dF\27[J"):format(display.shown))
    display.shown = 0
  end
end

--- A line that stays.
function Display:note(text)
  if self.quiet then
    return
  end
  erase(self)
  engine.write(text .. "\n")
end

--- A line that stays on the start or the good end of a case, unless there are many.
function Display:note_good(text)
  if self.tally.total <= few[self.width and "terminal" or "other"] then
    self:note(text)
  end
end

local function refresh(self, running, now)
  erase(self)
  local lines = {}
  if self.tally.total > 1 then
    lines[1] = progress.sweep_line(self.tally, #running, now):sub(1, self.width - 1)
  end
  for i = 1, math.min(#running, most_jobs) do
    local job = running[i]
    local line = job.progress and progress.line(job.case.id, job.progress) or job.case.id .. "  starting"
    lines[#lines + 1] = line:sub(1, self.width - 1)
  end
  if #lines > 0 then
    engine.write(table.concat(lines, "\n") .. "\n")
  end
  self.shown = #lines
end

--- Shows the running jobs ({case =, progress =, noted =}) if it is time to.
function Display:update(running)
  if self.quiet then
    return
  end
  local now = engine.clock()
  if self.width then
    if now - self.last >= between_refreshes then
      self.last = now
      refresh(self, running, now)
    end
    return
  end
  if self.tally.total > few.other then
    if now - self.last >= between_lines then
      self.last = now
      engine.write(progress.sweep_line(self.tally, #running, now) .. "\n")
    end
    return
  end
  for _, job in ipairs(running) do
    if job.progress and now - job.noted >= between_lines then
      job.noted = now
      engine.write(progress.line(job.case.id, job.progress) .. "\n")
    end
  end
end

function Display:finish()
  erase(self)
end

--- A display on standard output of so many cases; a quiet one shows nothing.
function progress.display(quiet, total)
  local tally = { total = total, done = 0, failed = 0, began = engine.clock() }
  return setmetatable({ quiet = quiet, tally = tally, width = engine.terminal_width(), shown = 0, last = 0 }, Display)
end

return progress
