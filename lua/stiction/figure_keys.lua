-- The keys of every table that a figure is made of, with what they mean: for the check of keys and for `stiction help figure`.
local common = {
  { "name", "of its file, without .png" },
  { "title", "above the plot" },
  { "width", "\"single\" (85 mm) or \"double\" (175 mm)" },
  { "height", "mm; default by the content" },
  { "dpi", "dots per inch of the PNG, which states them, 100 to 600; default 300" },
  { "svg", "true: NAME.svg too, in the size of print: lines, areas and letters as paths, meshes as pictures of `dpi`" },
  { "pdf", "true: NAME.pdf too, in the size of print: lines and areas as paths, letters as text, meshes as pictures of `dpi`" },
}

local function with_common(keys)
  local list = {}
  for _, part in ipairs { common, keys } do
    for _, key in ipairs(part) do
      list[#list + 1] = key
    end
  end
  return list
end

local keys = {}

--- In the order of the help page: {name, what it is, {{key, meaning}, ...}}.
keys.tables = {
  { "lines", "figure.lines{ ... }: curves over one pair of axes", with_common {
    { "x", "axis{ ... }" },
    { "y", "axis{ ... }" },
    { "curves", "list of curve{ ... }" },
    { "legend", "\"top right\", \"top left\", \"bottom right\", \"bottom left\", \"below\" or \"none\"; default: where there is "
      .. "room" },
    { "colours", "\"distinct\" or \"sequential\", along the order of the curves" },
    { "marks", "vertical lines: list of {x =, label =}" },
  } },
  { "axis", "an axis, a table without a constructor", {
    { "label", "text beside it" },
    { "unit", "in which it is drawn; default 1" },
    { "log", "true: logarithmic" },
    { "range", "{low, high}; default: all data" },
  } },
  { "curve", "a curve, a table without a constructor", {
    { "label", "in the legend" },
    { "case", "whose series are meant" },
    { "file", "an HDF5 file instead of a case, from the output folder on" },
    { "x", "\"probe/column\" or a list of numbers or quantities; default: time" },
    { "y", "\"probe/column\" or a list" },
    { "x_shift", "is taken away from x first" },
    { "y_shift", "is taken away from y first" },
    { "x_sign", "then x is multiplied by this" },
    { "y_sign", "then y is multiplied by this" },
    { "component", "which of a column that has several, from 1" },
    { "colour", "0, 1, ... 6 of the palette; default: the order" },
    { "style", "\"solid\", \"dash\", \"dot\", \"dashdot\" or \"points\"" },
    { "error", "of y where x and y are lists: half lengths of the bars at the points, a list or one for all" },
    { "x_error", "of x likewise" },
    { "names", "list of texts beside the points, where x and y are lists" },
    { "at_most", "list of true and false where x and y are lists: points that stand for what lies there or below are triangles" },
  } },
  { "mark", "a vertical line, a table without a constructor", {
    { "x", "where" },
    { "label", "beside it" },
  } },
  { "field", "figure.field{ ... }: a mesh in colours at one time", with_common {
    { "case", "whose fields are meant" },
    { "file", "a .pvd, .vtu or .vti file instead of a case, from the output folder on" },
    { "time", "a time, the nearest frame to it; or \"last\" (default)" },
    { "show_time", "false: without the time of the frame at the top right" },
    { "array", "displacement, velocity, cauchy_stress, von_mises, beta, contact_pressure, normal_adhesion, "
      .. "tangential_adhesion or status" },
    { "component", "of a vector \"x\", \"y\" or \"z\", of a tensor \"xx\", \"yy\", \"zz\", \"xy\", \"yz\" or \"xz\", or their number "
      .. "from 1; default: \"magnitude\"" },
    { "unit", "of the colour bar" },
    { "label", "of the colour bar; default: the array's name and component" },
    { "deformed", "true: at the displaced nodes" },
    { "range", "{low, high} of the colours" },
    { "window", "{xmin, xmax, ymin, ymax}: what is shown" },
    { "window_unit", "of the picture's axes; default m, in which plain numbers of window, crop, sphere and obstacles always are" },
    { "mesh", "true: with the edges of cells" },
    { "scale_bar", "a length, e.g. 1*mm" },
    { "view", "of a solid: {azimuth =, elevation =} in degrees, default 30 and 25" },
    { "mirror", "list of \"x\", \"y\", \"z\": shown with its image across x = 0, ..." },
    { "crop", "a solid cut by a box: {xmin =, xmax =, ymin =, ymax =, zmin =, zmax =}, any of them" },
    { "film", "true or {frames = how many, spread evenly; default all, rate = of them a second; default 10}: NAME.ogv "
      .. "(Ogg/Theora) instead of NAME.png, all frames in one window and one range of colours" },
    { "sphere", "a rigid sphere or circle: {centre =, radius =, path = {times =, x =, y =, z =}}" },
    { "obstacles", "of a plane picture: false: none; default: those of the case, as they are at the time (free ones need a "
      .. "probe.rigid; at the start if not deformed); or a list of obstacle{ ... }" },
  } },
  { "obstacle", "a rigid obstacle of a plane picture, a table without a constructor", {
    { "centre", "of a disc" },
    { "radius", "of a disc" },
    { "point", "on the border of a half-plane" },
    { "normal", "outward, of a half-plane" },
    { "points", "{x1, y1, x2, y2, ...} of an outline" },
    { "closed", "true: the outline ends where it begins" },
    { "hollow", "true: a line, the inside is not grey" },
    { "pivot", "that it turns about; default: centre or point" },
    { "path", "{times =, x =, y =, angle =}: where it goes" },
  } },
  { "panel", "figure.panel{ ... }: several of these beside each other", with_common {
    { "columns", "how many beside each other; default 2" },
    { "common_range", "true: fields of one array and unit that leave their range open share one; default false" },
    { "figures", "list of figure.lines, figure.field and figure.map" },
  } },
  { "map", "figure.map{ ... }: a table of outcomes, each a colour and a letter", with_common {
    { "blocks", "side by side, the rows shared out" },
    { "columns", "list of texts" },
    { "kinds", "list of {letter =, label =, colour = 0, 1, ... of the palette}" },
    { "rows", "list of {group =, label =, cells = a letter of a kind per column, . for none}" },
  } },
}

--- The keys of smaller tables.
keys.small = {
  scale_bar = { "length", "unit" },
  film = { "frames", "rate" },
  view = { "azimuth", "elevation" },
  crop = { "xmin", "xmax", "ymin", "ymax", "zmin", "zmax" },
  sphere = { "centre", "radius", "path" },
  path = { "times", "x", "y", "z", "angle" },
}

--- By table the set of its keys.
keys.known = {}
for _, entry in ipairs(keys.tables) do
  keys.known[entry[1]] = {}
  for _, key in ipairs(entry[3]) do
    keys.known[entry[1]][key[1]] = true
  end
end
for name, list in next, keys.small do
  keys.known[name] = {}
  for _, key in ipairs(list) do
    keys.known[name][key] = true
  end
end

return keys
