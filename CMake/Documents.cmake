# ninja doxygen: pages of the headers, in doxygen/html of the build folder.
find_package(Doxygen QUIET)
if (NOT DOXYGEN_FOUND)
  return()
endif ()
set(DOXYGEN_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/doxygen")
set(DOXYGEN_PROJECT_BRIEF "Conforming hexahedral and tetrahedral meshes from volume fractions")
set(DOXYGEN_STRIP_FROM_PATH "${PROJECT_SOURCE_DIR}")
set(DOXYGEN_FILE_PATTERNS *.h *.hpp)
# The comment at the top of a header tells of the file.
set(DOXYGEN_INPUT_FILTER "sed '1s,^/[*][*]$,/** @file,'")
set(DOXYGEN_JAVADOC_AUTOBRIEF YES)
set(DOXYGEN_EXTRACT_ALL YES)
set(DOXYGEN_EXTRACT_STATIC YES)
set(DOXYGEN_SORT_MEMBER_DOCS NO)
set(DOXYGEN_MACRO_EXPANSION YES)
set(DOXYGEN_EXPAND_ONLY_PREDEF YES)
set(DOXYGEN_PREDEFINED
  "vtkTypeMacro(type,base)="
  "vtkBooleanMacro(name,type)="
  "vtkSetMacro(name,type)=virtual void Set##name(type value)"
  "vtkSetClampMacro(name,type,least,most)=virtual void Set##name(type value)"
  "vtkGetMacro(name,type)=virtual type Get##name()")
set(DOXYGEN_HAVE_DOT NO)
set(DOXYGEN_QUIET YES)
set(DOXYGEN_WARN_IF_UNDOCUMENTED NO) # not every parameter needs a word
doxygen_add_docs(doxygen Grid Shapes Parallel Filters IO InSitu
  COMMENT "Pages of the headers: ${PROJECT_BINARY_DIR}/doxygen/html/index.html")
