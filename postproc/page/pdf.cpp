// A page of PDF by VTK's device and its libharu: letters as text, which the device would draw as paths.
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <vector>

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPDFContextDevice2D.h>
#include <vtkPath.h>
#include <vtkPoints.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtk_libharu.h>

#include "core/error.hpp"
#include "page/drawing.hpp"

namespace stiction::postproc {

namespace {

/// libharu writes numbers next to 0 wrongly.
float rounded(double value) {
  return static_cast<float>(std::round(1e4 * value) / 1e4);
}

class TextDevice : public vtkPDFContextDevice2D {
public:
  static TextDevice* New() {
    auto* device = new TextDevice;
    device->InitializeObjectBase();
    return device;
  }
  vtkTypeMacro(TextDevice, vtkPDFContextDevice2D)

      void write_on(HPDF_Doc doc, HPDF_Page page, HPDF_Font font) {
    SetHaruObjects(&doc, &page);
    page_ = page;
    font_ = font;
  }

  void DrawString(float* at, vtkStdString const& text) override {
    auto const* colour = TextProp->GetColor();
    HPDF_Page_GSave(page_);
    HPDF_Page_SetRGBFill(page_, static_cast<float>(colour[0]), static_cast<float>(colour[1]),
                         static_cast<float>(colour[2]));
    HPDF_Page_BeginText(page_);
    HPDF_Page_SetFontAndSize(page_, font_, static_cast<float>(TextProp->GetFontSize()));
    double const turn = TextProp->GetOrientation() * 3.14159265358979323846 / 180, c = std::cos(turn),
                 s = std::sin(turn);
    double const x = -0.5 * TextProp->GetJustification() * HPDF_Page_TextWidth(page_, text.c_str());
    double const y = baseline();
    HPDF_Page_SetTextMatrix(page_, rounded(c), rounded(s), rounded(-s), rounded(c),
                            rounded(at[0] + c * x - s * y), rounded(at[1] + s * x + c * y));
    HPDF_Page_ShowText(page_, text.c_str());
    HPDF_Page_EndText(page_);
    HPDF_Page_GRestore(page_);
  }

  /// All quads in one path, turned alike, so that no seams show between them.
  void DrawQuadStrip(float* points, int count) override {
    auto const* colour = Brush->GetColor();
    HPDF_Page_GSave(page_);
    HPDF_Page_SetRGBFill(page_, colour[0] / 255.0F, colour[1] / 255.0F, colour[2] / 255.0F);
    for (int i = 0; i + 3 < count; i += 2)
      add_quad(points + 2 * static_cast<std::ptrdiff_t>(i));
    HPDF_Page_Fill(page_);
    HPDF_Page_GRestore(page_);
  }

private:
  /// Of a strip: its points 0 and 1, 2 and 3 lie across from each other.
  void add_quad(float const* p) {
    float const area = (p[6] - p[0]) * (p[5] - p[3]) - (p[4] - p[2]) * (p[7] - p[1]);
    int const forward[] = {0, 1, 3, 2}, backward[] = {0, 2, 3, 1};
    auto const& order = area > 0 ? backward : forward;
    HPDF_Page_MoveTo(page_, rounded(p[0]), rounded(p[1]));
    for (int k = 1; k < 4; ++k)
      HPDF_Page_LineTo(page_, rounded(p[2 * order[k]]), rounded(p[2 * order[k] + 1]));
    HPDF_Page_ClosePath(page_);
  }

  /// Where the line below the letters is, from the point at which a text is placed.
  double baseline() {
    vtkNew<vtkTextProperty> upright;
    upright->ShallowCopy(TextProp);
    upright->SetOrientation(0);
    vtkNew<vtkPath> outline;
    vtkTextRenderer::GetInstance()->StringToPath(upright, vtkStdString("H"), outline, text_dpi);
    double bounds[6] = {};
    outline->GetPoints()->GetBounds(bounds);
    return bounds[2];
  }

  HPDF_Page page_ = nullptr;
  HPDF_Font font_ = nullptr;
};

[[noreturn]] void refuse(std::filesystem::path const& file, HPDF_STATUS status) {
  throw core::RunError(fmt::format("{}: libharu refuses with error 0x{:04x}", file.string(), status));
}

std::string bytes_of(HPDF_Doc doc) {
  HPDF_SaveToStream(doc);
  HPDF_ResetStream(doc);
  std::string bytes;
  std::vector<HPDF_BYTE> buffer(1 << 16);
  for (HPDF_UINT32 count = 0;;) {
    count = static_cast<HPDF_UINT32>(buffer.size());
    HPDF_ReadFromStream(doc, buffer.data(), &count);
    if (count == 0)
      return bytes;
    bytes.append(reinterpret_cast<char const*>(buffer.data()), count);
  }
}

} // namespace

void write_pdf(Drawing const& drawing, std::filesystem::path const& file) {
  constexpr double point = 72.0 / dots_per_inch; // of PDF, in a pixel
  std::unique_ptr<std::remove_pointer_t<HPDF_Doc>, decltype(&HPDF_Free)> const held(
      HPDF_New(nullptr, nullptr), &HPDF_Free);
  HPDF_Doc const doc = held.get();
  core::expect(doc != nullptr, "memory for a page of PDF");
  HPDF_SetCompressionMode(doc, HPDF_COMP_ALL);
  HPDF_SetInfoAttr(doc, HPDF_INFO_TITLE, file.stem().c_str());
  HPDF_UseUTFEncodings(doc);
  auto const* name = HPDF_LoadTTFontFromFile(doc, STICTION_FONT, HPDF_TRUE);
  HPDF_Font const font = name == nullptr ? nullptr : HPDF_GetFont(doc, name, "UTF-8");
  if (font == nullptr)
    refuse(file, HPDF_GetError(doc));
  HPDF_Page const page = HPDF_AddPage(doc);
  HPDF_Page_SetWidth(page, static_cast<float>(point * drawing.size.width));
  HPDF_Page_SetHeight(page, static_cast<float>(point * drawing.size.height));
  HPDF_Page_Concat(page, static_cast<float>(point), 0, 0, static_cast<float>(point), 0, 0);
  vtkNew<TextDevice> device;
  device->write_on(doc, page, font);
  vtkNew<vtkContext2D> context;
  context->Begin(device);
  paint(drawing, Canvas(*context));
  context->End();
  auto const bytes = bytes_of(doc);
  if (HPDF_GetError(doc) != HPDF_OK && HPDF_GetError(doc) != HPDF_STREAM_EOF)
    refuse(file, HPDF_GetError(doc));
  write_whole(bytes, file);
}

} // namespace stiction::postproc
