# The reference of the C++ and C headers: run doxygen Doxyfile.cpp, and open html_cpp/index.html.
@INCLUDE = Doxyfile
PROJECT_NAME = "mip for C++"
FILE_PATTERNS = *.h *.hpp *.md
OPTIMIZE_OUTPUT_FOR_C = NO
HTML_OUTPUT = html_cpp
# Values of enumerations and members of commands are documented where C has them.
EXTRACT_ALL = YES
EXCLUDE_SYMBOLS = mip::detail mip::detail::*
PREDEFINED += MIP_LAYOUT(a,b,c)= MIP_NAMES_OF(a,b,c)= MIP_COMMAND_OF(a,b)= MIP_LAYOUT_TYPE=class MIP_PORT_TYPE=class
