#include <rolling_contact/base/text.h>
#include <rolling_contact/plot/svg_canvas.h>

#include <array>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    double
    character_width(const char character)
    {
      const std::string letter(1, character);
      if (std::string("iljtfrI.,:;|'!()[]/ ").find(letter) != std::string::npos)
        return 0.36;
      if (std::string("mwMW%@").find(letter) != std::string::npos)
        return 0.92;
      return character >= 'A' && character <= 'Z' ? 0.70 : 0.61;
    }



    double
    text_width(const std::string &text)
    {
      double width = 0.;
      for (const char character : text)
        if ((static_cast<unsigned char>(character) & 0xC0) != 0x80)
          width += character_width(character);
      return width;
    }
  } // namespace



  std::string
  pixels(const double value)
  {
    return significant(std::round(100. * value) / 100., 7);
  }



  PlotText
  plain_text(const std::string &text)
  {
    const std::string valid = valid_utf8(text);

    std::string markup;
    for (const char character : valid)
      if (character == '&')
        markup += "&amp;";
      else if (character == '<')
        markup += "&lt;";
      else if (character == '>')
        markup += "&gt;";
      else if (static_cast<unsigned char>(character) < 0x20)
        markup += ' ';
      else
        markup += character;
    return {markup, text_width(valid)};
  }



  PlotText
  with_minus_sign(const std::string &number)
  {
    const bool negative = !number.empty() && number.front() == '-';
    return plain_text(negative ? "\u2212" + number.substr(1) : number);
  }



  PlotText
  power_of_ten(const std::string &factor, const int exponent)
  {
    const PlotText base   = plain_text(factor + "10");
    const PlotText raised = with_minus_sign(std::to_string(exponent));
    return {base.markup + "<tspan dy=\"-5\" font-size=\"9\">" + raised.markup +
              "</tspan>",
            base.width + 0.75 * raised.width};
  }



  SvgCanvas::SvgCanvas(const double       width,
                       const double       height,
                       const PlotText    &title,
                       const std::string &text_colour)
  {
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << pixels(width)
        << "\" height=\"" << pixels(height) << "\" viewBox=\"0 0 "
        << pixels(width) << ' ' << pixels(height)
        << "\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" "
        << "fill=\"" << text_colour << "\">\n"
        << "<title>" << title.markup << "</title>\n";
    rectangle({0., 0., width, height}, "fill=\"white\"");
  }



  void
  SvgCanvas::rectangle(const PlotBox &box, const std::string &attributes)
  {
    out << "<rect x=\"" << pixels(box.left) << "\" y=\"" << pixels(box.top)
        << "\" width=\"" << pixels(box.right - box.left) << "\" height=\""
        << pixels(box.bottom - box.top) << "\" " << attributes << "/>\n";
  }



  void
  SvgCanvas::line(const PlotPoint   &from,
                  const PlotPoint   &to,
                  const std::string &attributes)
  {
    out << "<line x1=\"" << pixels(from.x) << "\" y1=\"" << pixels(from.y)
        << "\" x2=\"" << pixels(to.x) << "\" y2=\"" << pixels(to.y) << "\" "
        << attributes << "/>\n";
  }



  void
  SvgCanvas::polyline(const std::vector<PlotPoint> &points,
                      const std::string            &attributes)
  {
    out << "<polyline " << attributes << " points=\"";
    PlotPoint last{-1., -1.};
    for (const PlotPoint &point : points)
      if (std::hypot(point.x - last.x, point.y - last.y) > 0.2 ||
          &point == &points.back())
        {
          out << pixels(point.x) << ',' << pixels(point.y) << ' ';
          last = point;
        }
    out << "\"/>\n";
  }



  void
  SvgCanvas::polygon(const std::vector<PlotPoint> &points,
                     const std::string            &attributes)
  {
    out << "<polygon points=\"";
    for (const PlotPoint &point : points)
      out << pixels(point.x) << ',' << pixels(point.y) << ' ';
    out << "\" " << attributes << "/>\n";
  }



  void
  SvgCanvas::circle(const PlotPoint   &centre,
                    const double       radius,
                    const std::string &attributes)
  {
    out << "<circle cx=\"" << pixels(centre.x) << "\" cy=\"" << pixels(centre.y)
        << "\" r=\"" << pixels(radius) << "\" " << attributes << "/>\n";
  }



  void
  SvgCanvas::text(const PlotText    &text,
                  const PlotPoint   &point,
                  const double       font,
                  const Anchor       anchor,
                  const std::string &attributes)
  {
    if (text.markup.empty())
      return;
    const std::array<const char *, 3> anchors{{"start", "middle", "end"}};
    out << "<text x=\"" << pixels(point.x) << "\" y=\"" << pixels(point.y)
        << "\" font-size=\"" << pixels(font) << "\" text-anchor=\""
        << anchors[static_cast<std::size_t>(anchor)] << "\" " << attributes
        << '>' << text.markup << "</text>\n";
  }



  std::string
  SvgCanvas::svg() const
  {
    return out.str() + "</svg>\n";
  }
} // namespace RollingContact
