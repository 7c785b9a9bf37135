-- A shallow copy of a table, without its metatable.
return function(t)
  local twin = {}
  for key, value in pairs(t) do
    twin[key] = value
  end
  return twin
end
