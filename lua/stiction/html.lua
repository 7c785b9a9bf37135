-- Pieces of pages that need nothing else: their style, texts, tables.
local html = {}

html.style = [[
body { font: 16px/1.5 sans-serif; margin: 0 auto; max-width: 60rem; padding: 1rem; color: #111; background: #fff }
pre, code { font: 14px/1.45 monospace; background: #f2f2f2 } pre { padding: .7rem; overflow-x: auto } code { padding: 0 .2rem }
table { border-collapse: collapse; width: 100% } td, th { border-bottom: 1px solid #ccc; padding: .25rem .6rem; text-align: left;
vertical-align: top } a { color: #004488 }
]]

local signs = { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;" }

--- A value as text of a page.
function html.plain(text)
  return (tostring(text):gsub('[&<>"]', signs))
end

--- A table: rows of texts below the heading, the first of each as code.
function html.rows(list, heading)
  local heads = {}
  for i, text in ipairs(heading) do
    heads[i] = html.plain(text)
  end
  local lines = { "<table><tr><th>" .. table.concat(heads, "</th><th>") .. "</th></tr>" }
  for _, row in ipairs(list) do
    local cells = { ("<code>%s</code>"):format(html.plain(row[1])) }
    for i = 2, #heading do
      cells[i] = html.plain(row[i])
    end
    lines[#lines + 1] = "<tr><td>" .. table.concat(cells, "</td><td>") .. "</td></tr>"
  end
  lines[#lines + 1] = "</table>"
  return table.concat(lines, "\n")
end

return html
