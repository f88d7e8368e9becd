# The examples in a header's comments, which stand between "~~~{.cpp}" and "~~~".
/^\/\/\/ ~~~{\.cpp}$/,/^\/\/\/ ~~~$/{
/~~~/!s|^/// \{0,1\}||p
}
