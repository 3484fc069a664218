-- page.lua: one page of the book, for book.sh: pandoc --lua-filter=page.lua -M page=chapters/01_ray/README.md
-- Anchors begin with the page's name, links to other pages become anchors, links to code lead out of build/,
-- and pictures go into the text.
local page, folder, titled  -- titled: its title has been met

-- "chapters/01_ray", "../09_aabb/box.h" -> "chapters/09_aabb/box.h"
local function path_of(from, to)
    local parts = {}
    for part in (from .. '/' .. to):gmatch('[^/]+') do
        if part == '..' and #parts > 0 then table.remove(parts)
        elseif part ~= '.' then table.insert(parts, part) end
    end
    return table.concat(parts, '/')
end

-- The anchor of a page: "chapters/01_ray/README.md" -> "chapters-01_ray-README"
local function anchor_of(path) return (path:gsub('%.md$', ''):gsub('/', '-')) end

local function exists(path)
    local f = io.open(path)
    if f then f:close() end
    return f ~= nil
end

-- Pages of the book are anchors; all else is a file of the tree.
local function target_of(target)
    if target:match('^%a+:') then return target end
    local path, part = target:match('^([^#]*)#?(.*)$')
    local full = path == '' and page or path_of(folder, path)
    if full:match('%.md$') and (full:match('^chapters/') or full:match('^README') or full:match('^tests/README')) then
        return '#' .. anchor_of(full) .. (part ~= '' and '-' .. part or '')
    end
    return '../' .. full
end

local function picture(src)
    local full = path_of(folder, src)
    local kind = full:match('%.svg$') and 'svg+xml' or full:match('%.(%w+)$')
    if not exists(full) then io.stderr:write('[WARNING] no picture ' .. full .. '\n') return src end
    if os.getenv('PICTURES') == 'no' then return '../' .. full end
    local data = pandoc.pipe('sh', {'-c', 'base64 <"$0" | tr -d "\\n"', full}, '')
    return 'data:image/' .. kind .. ';base64,' .. data
end

local function raw(e)
    e.text = e.text:gsub('src="([^"]*)"', function(src) return 'src="' .. picture(src) .. '"' end)
    return e
end

return {
    {Meta = function(m)
        page = pandoc.utils.stringify(m.page)
        folder = page:match('^(.*)/[^/]*$') or '.'
    end},
    {Header = function(h)
        h.identifier = anchor_of(page) .. (titled and '-' .. h.identifier or '')
        titled = true
        return h
     end,
     Link = function(l) l.target = target_of(l.target) return l end,
     Str = function(s)  -- what was meant as a formula, and is none: its braces do not match
        if s.text:find('%$') then io.stderr:write('[WARNING] ' .. page .. ': no formula: ' .. s.text .. '\n') end
     end,
     Image = function(i) i.src = picture(i.src) return i end,
     RawInline = raw, RawBlock = raw},
}
