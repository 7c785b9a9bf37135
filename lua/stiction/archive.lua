-- Archives of outputs: made and unpacked by tar, their files checked against what describes them.
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local jobs = require "stiction.jobs"

local archive = { metadata = "ro-crate-metadata.json" }

--- Runs a program that comes with every Debian; what it printed. Fails with what it complained of.
local function must(words, what)
  local code, printed = jobs.program(words, { "LC_ALL=C" })
  if code ~= 0 then
    fault.run("%s: %s", what, (printed:gsub("%s+$", "")))
  end
  return printed
end

--- True if the path names a file that is an archive.
function archive.is(path)
  return engine.kind_of_path(path) == "file" and (path:find("%.tar%.?%w*$") or path:find("%.tgz$")) ~= nil
end

--- Unpacks an archive into the folder; the folder that it holds. Bad input if it is not one of ours.
function archive.unpack(file, folder)
  local code, printed = jobs.program({ "tar", "-xf", file, "-C", folder }, { "LC_ALL=C" })
  if code ~= 0 then
    fault.input("%s is not an archive, or it is damaged: %s", file, (printed:gsub("%s+$", "")))
  end
  for _, path in ipairs(engine.list(folder, false)) do
    if engine.kind_of_path(path .. "/" .. archive.metadata) == "file" then
      return path
    end
  end
  fault.input("%s holds no %s: it was not made by 'stiction pack'", file, archive.metadata)
end

--- Writes `file` with the folder's files (paths from there on) and the metadata, below one folder called `name`.
--- place: an empty folder.
function archive.pack(file, folder, files, name, metadata, place)
  local list = {}
  for i, path in ipairs(files) do
    list[i] = path .. "\0"
  end
  engine.make_folder(place .. "/own")
  engine.write_file(place .. "/list", table.concat(list))
  engine.write_file(place .. "/own/" .. archive.metadata, metadata)
  local draft = file .. ".part"
  local held, reason = engine.call(must, { "tar", "-czf", draft, "--owner=0", "--group=0", "--numeric-owner",
    "--no-recursion", "--transform", "s,^," .. name:gsub("[,\\&]", "\\%0") .. "/,", "-C", place .. "/own",
    archive.metadata, "-C", engine.absolute(folder), "--null", "--verbatim-files-from", "-T", place .. "/list" },
    "cannot write " .. file)
  if not held then
    engine.remove(draft)
    error(reason, 0)
  end
  engine.rename(draft, file)
end

--- SHA-256 of each of the folder's files, by path.
function archive.sums(folder, files)
  local sums, at = {}, 1
  while at <= #files do
    local words = { "sha256sum", "-z", "--" }
    for i = at, math.min(at + 499, #files) do
      words[#words + 1] = folder .. "/" .. files[i]
    end
    for sum, path in must(words, "cannot read " .. folder):gmatch("(%x+)  ([^%z]*)%z") do
      sums[path:sub(#folder + 2)] = sum
    end
    at = at + 500
  end
  return sums
end

--- The folder's files, as they stand from there on, apart from locks, drafts and the metadata.
function archive.files(folder)
  local list = {}
  for _, path in ipairs(engine.list(folder, true)) do
    local own = path:sub(#folder + 2)
    local left_out = ("/" .. own):find("/.", 1, true) or own:find("%.part$") or own == archive.metadata
    list[#list + 1] = not left_out and own or nil
  end
  return list
end

local function decoded(path)
  return (path:gsub("%%(%x%x)", function(digits) return string.char(tonumber(digits, 16)) end))
end

--- The files that the metadata lists, with their sums by path; bad input if it cannot be read.
local function listed(folder)
  local path = folder .. "/" .. archive.metadata
  local crate = engine.decode_json(engine.read_file(path) or "")
  local graph = type(crate) == "table" and crate["@graph"]
  if type(graph) ~= "table" then
    fault.input("%s is damaged: it has no @graph", path)
  end
  local sums = {}
  for _, entity in ipairs(graph) do
    local kind, id = type(entity) == "table" and entity["@type"], type(entity) == "table" and entity["@id"]
    local is_file = kind == "File" or type(kind) == "table" and kind[1] == "File"
    if is_file and type(id) == "string" then
      sums[decoded(id)] = tostring(entity.sha256)
    end
  end
  return sums
end

--- Where the folder's files are not what its metadata lists: sentences.
function archive.complaints(folder)
  local wanted, files, list = listed(folder), archive.files(folder), {}
  local sums = archive.sums(folder, files)
  for _, path in ipairs(files) do
    if not wanted[path] then
      list[#list + 1] = path .. " is not listed"
    elseif wanted[path] ~= sums[path] then
      list[#list + 1] = path .. " is not what was packed"
    end
    wanted[path] = nil
  end
  for path in pairs(wanted) do
    list[#list + 1] = path .. " is missing"
  end
  table.sort(list)
  return list
end

return archive
