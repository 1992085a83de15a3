# Solves the scene that the arguments give, and prints pull-off and curve, by libpulloff:
#     julia pull_off.jl tabor=3 amplitude=1 wavelength=20
# Lengths are in epsilon, loads in pi w R.
const LIB = "libpulloff.so.0"

"Calls f(message); a status other than 0 becomes an error with the message."
function checked(f)
    message = zeros(UInt8, 1024)
    status = f(message)
    status == 0 || error(GC.@preserve message unsafe_string(pointer(message)))
end

function solve(keys)
    scene, result = Ref(C_NULL), Ref(C_NULL)
    checked(m -> ccall((:pulloff_scene_create, LIB), Cint, (Ref{Ptr{Cvoid}}, Ptr{UInt8}), scene, m))
    try
        for (key, value) in keys
            checked(m -> ccall((:pulloff_scene_set, LIB), Cint, (Ptr{Cvoid}, Cstring, Cstring, Ptr{UInt8}), scene[], key, value, m))
        end
        checked(m -> ccall((:pulloff_solve, LIB), Cint, (Ptr{Cvoid}, Ref{Ptr{Cvoid}}, Ptr{UInt8}), scene[], result, m))
    catch
        ccall((:pulloff_result_destroy, LIB), Cvoid, (Ptr{Cvoid},), result[])
        rethrow()
    finally
        ccall((:pulloff_scene_destroy, LIB), Cvoid, (Ptr{Cvoid},), scene[])
    end
    return result[]
end

"One number of the JSON document, by its path."
function number(result, path)
    value = Ref{Cdouble}()
    checked(m -> ccall((:pulloff_result_number, LIB), Cint, (Ptr{Cvoid}, Cstring, Ref{Cdouble}, Ptr{UInt8}), result, path, value, m))
    return value[]
end

"One number of each member of an array."
function column(result, path, name)
    count = Ref{Csize_t}()
    checked(m -> ccall((:pulloff_result_count, LIB), Cint, (Ptr{Cvoid}, Cstring, Ref{Csize_t}, Ptr{UInt8}), result, path, count, m))
    values = Vector{Cdouble}(undef, count[])
    checked(m -> ccall((:pulloff_result_column, LIB), Cint, (Ptr{Cvoid}, Cstring, Cstring, Ptr{Cdouble}, Csize_t, Ptr{UInt8}),
                       result, path, name, values, count[], m))
    return values
end

result = solve([split(word, "="; limit=2) for word in [ARGS; "want=curve"]])
println("pull-off force ", number(result, "pull_off.force"), " +- ", number(result, "pull_off.error_estimate"))
println(length(column(result, "curve", "approach")), " points, least load ", minimum(column(result, "curve", "load")))
ccall((:pulloff_result_destroy, LIB), Cvoid, (Ptr{Cvoid},), result)
