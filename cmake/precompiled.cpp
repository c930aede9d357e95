// Of the targets that precompile headers: a target has at least one source.
