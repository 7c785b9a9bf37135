local x = "ab"
for _ = 1, 60 do x = x .. x end
