# The arrows of src/ (docs/architecture.md). A module may include itself and what is on a lower level; a library is
# included by the .cpp files of its own modules only, so that no header depends on it.

BEGIN {
    split("core=0 geo=1 mesh=2 terrain=3 flight=3 trace=4 shade=4 film=4 io=5 config=5 shot=6 app=7", levels, " ")
    for (i in levels) { split(levels[i], pair, "="); level[pair[1]] = pair[2] }

    home["^(gdal|ogr|cpl|vrt)[a-z_]*[.]h$"] = "io"
    home["^(OpenEXR|Imath)/"] = "io"
    home["^OpenImageIO/"] = "io"
    home["^OpenColorIO/"] = "io"
    home["^openssl/"] = "io"
    home["^assimp/"] = "io"
    home["^geos_c[.]h$"] = "mesh"
    home["^GeographicLib/"] = "geo"
    home["^yaml-cpp/"] = "config"
    home["^embree3/"] = "trace"
    home["^hwy/"] = "trace shade"
    home["^(oneapi/)?tbb/"] = "core"
    home["^CLI/"] = "app"
    home["^nlohmann/"] = "io app"
    home["^fmt/"] = "any"
    home["^(sys/|(unistd|fcntl|poll|spawn|signal|stdlib)[.]h$)"] = "any"  # POSIX
}

function complain(what) { print FILENAME ":" FNR ": " what; bad = 1 }

FNR == 1 {
    split(FILENAME, parts, "/")
    module = parts[1]
    is_header = FILENAME ~ /[.]h$/
    if (!(module in level)) complain("unknown module " module)
}

/^[ \t]*#[ \t]*include[ \t]*["<]/ {
    name = $0
    sub(/^[^"<]*["<]/, "", name)
    sub(/[">].*$/, "", name)
    if (name !~ /[.\/]/) next  # the standard library

    folder = name
    sub(/\/.*$/, "", folder)
    if (folder in level) {
        if (folder != module && level[folder] >= level[module]) complain(module " may not include " name)
        next
    }
    where = ""
    for (pattern in home) if (name ~ pattern) where = home[pattern]
    if (where == "") complain("unknown header " name)
    else if (is_header && name !~ /_fwd[.]hpp$/) complain(name " belongs into .cpp files")
    else if (where != "any" && index(" " where " ", " " module " ") == 0) complain(name " belongs into " where)
}

END { exit bad }
