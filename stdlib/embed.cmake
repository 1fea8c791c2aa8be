# Writes a .cpp that holds every module as a raw string (see stdlib.hpp).
set(text "#include \"stdlib/stdlib.hpp\"\n\nnamespace toile {\n\nconst std::vector<Module>& stdlib_modules() {\n  static const std::vector<Module> modules{\n")
foreach(module IN LISTS MODULES)
  get_filename_component(name ${module} NAME_WE)
  file(READ ${module} content)
  string(APPEND text "      {\"${name}\", R\"~toile~(${content})~toile~\"},\n")
endforeach()
string(APPEND text "  };\n  return modules;\n}\n\n}  // namespace toile\n")
file(WRITE ${OUTPUT} "${text}")
