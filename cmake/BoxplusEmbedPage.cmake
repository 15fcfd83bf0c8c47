# Writes the bytes of the viewer's page as a C++ source: cmake -DINPUT=page.html.gz -DOUTPUT=page.cpp -P this
file(READ "${INPUT}" bytes HEX)
string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(
  WRITE "${OUTPUT}"
  "#include \"viewer/server/page.h\"

namespace boxplus::viewer {
namespace {
constexpr unsigned char kPage[] = {
${bytes}};
}  // namespace

std::string_view page_html_gz() {
  return {reinterpret_cast<const char*>(kPage), sizeof kPage};
}

}  // namespace boxplus::viewer
")
