# Writes a .cpp that holds every page of docs/errors as a raw string (see pages.hpp).
set(text "#include \"compiler/diag/pages.hpp\"\n\nnamespace toile {\n\nconst std::vector<ErrorPage>& error_pages() {\n  static const std::vector<ErrorPage> pages{\n")
foreach(page IN LISTS PAGES)
  get_filename_component(code ${page} NAME_WE)
  file(READ ${page} content)
  string(APPEND text "      {\"${code}\", R\"~toile~(${content})~toile~\"},\n")
endforeach()
string(APPEND text "  };\n  return pages;\n}\n\n}  // namespace toile\n")
file(WRITE ${OUTPUT} "${text}")
