#include <fmt/format.h>

#include <rolling_contact/fmu/description.h>

#include <cstdint>

namespace RollingContact::Fmu
{
  namespace
  {
    const char declaration[] = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

    std::string escaped(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        result += c == '&'    ? "&amp;"
                  : c == '<'  ? "&lt;"
                  : c == '>'  ? "&gt;"
                  : c == '"'  ? "&quot;"
                  : c == '\n' ? " "
                              : std::string(1, c);
      return result;
    }

    std::string attribute(const char *name, const std::string &value)
    {
      return fmt::format(" {}=\"{}\"", name, escaped(value));
    }

    std::string units_text()
    {
      std::string text = "  <UnitDefinitions>\n";
      for (const Unit &unit : units())
        {
          text += fmt::format("    <Unit name=\"{}\"><BaseUnit", unit.name);
          for (const auto &[name, exponent] : {std::pair("kg", unit.kg),
                                               std::pair("m", unit.m),
                                               std::pair("s", unit.s),
                                               std::pair("rad", unit.rad)})
            if (exponent != 0)
              text += fmt::format(" {}=\"{}\"", name, exponent);
          text += "/></Unit>\n";
        }
      return text + "  </UnitDefinitions>\n";
    }

    std::string log_categories(const ForceKind kind)
    {
      return std::string("  <LogCategories>\n"
                         "    <Category name=\"logStatusWarning\"/>\n") +
             (kind == ForceKind::program
                ? "    <Category name=\"logStatusDiscard\"/>\n"
                : "") +
             "    <Category name=\"logStatusError\"/>\n"
             "  </LogCategories>\n";
    }

    /** What the variable is at first, if the description says it. */
    std::string start_of(const Variable &variable, const DescriptionText &text)
    {
      switch (variable.source)
        {
          case Source::input:
            return fmt::format("{}", text.start[variable.number]);
          case Source::least_speed:
            return fmt::format("{}", default_least_speed);
          case Source::radius:
            return fmt::format("{}", text.radius);
          case Source::tape_circle:
            return fmt::format("{}", text.tape_circle);
          case Source::scene:
            return model_name;
          case Source::program:
            return text.program;
          default:
            return "";
        }
    }

    /** Causality, variability and initial, of both versions. */
    std::string role_of(const Variable &variable)
    {
      switch (variable.causality)
        {
          case Causality::independent:
            return " causality=\"independent\" variability=\"continuous\"";
          case Causality::input:
            return " causality=\"input\" variability=\"continuous\"";
          case Causality::parameter:
            return " causality=\"parameter\" variability=\"fixed\" "
                   "initial=\"exact\"";
          case Causality::constant:
            return " causality=\"local\" variability=\"constant\" "
                   "initial=\"exact\"";
          default:
            return std::string(" causality=\"output\" variability=\"") +
                   (variable.type == VariableType::boolean ? "discrete"
                                                           : "continuous") +
                   "\" initial=\"calculated\"";
        }
    }

    const char *type_of(const Variable &variable, const char *real)
    {
      return variable.type == VariableType::real      ? real
             : variable.type == VariableType::boolean ? "Boolean"
                                                      : "String";
    }

    std::string unit_of(const Variable &variable)
    {
      return variable.unit.empty() ? "" : attribute("unit", variable.unit);
    }

    std::string head_of(const Variable &variable)
    {
      return fmt::format("name=\"{}\" valueReference=\"{}\"{}{}",
                         variable.name,
                         variable.reference,
                         attribute("description", variable.description),
                         role_of(variable));
    }

    /** Attributes of the model, behind its version. */
    std::string model_of(const DescriptionText &text, const char *token)
    {
      return " modelName=\"wheelset on rails\"" + attribute(token, text.token) +
             attribute("description", text.title) +
             attribute("version", text.version) +
             " license=\"LGPL-2.1-or-later\"" +
             attribute("generationTool", "rolling-contact " + text.version) +
             " variableNamingConvention=\"structured\"";
    }

    const char *tool_of(const ForceKind kind)
    {
      return kind == ForceKind::program ? " needsExecutionTool=\"true\"" : "";
    }

    std::string experiment_of(const DescriptionText &text)
    {
      return fmt::format("  <DefaultExperiment startTime=\"0\" "
                         "stopTime=\"1\" stepSize=\"{}\"/>\n",
                         text.step);
    }
  } // namespace

  std::string description_2(const DescriptionText &text)
  {
    std::string xml = declaration + ("<fmiModelDescription fmiVersion=\"2.0\"" +
                                     model_of(text, "guid") +
                                     " numberOfEventIndicators=\"0\">\n");
    xml += fmt::format("  <CoSimulation modelIdentifier=\"{}\"{} "
                       "canHandleVariableCommunicationStepSize=\"true\" "
                       "canBeInstantiatedOnlyOncePerProcess=\"false\" "
                       "canNotUseMemoryManagementFunctions=\"true\" "
                       "canGetAndSetFMUstate=\"true\" "
                       "canSerializeFMUstate=\"true\"/>\n",
                       model_name,
                       tool_of(text.kind));
    xml += units_text() + log_categories(text.kind) + experiment_of(text) +
           "  <ModelVariables>\n";
    std::string  unknowns;
    unsigned int index = 0;
    for (const Variable &variable : variables(text.kind))
      {
        ++index;
        const std::string start = start_of(variable, text);
        xml +=
          fmt::format("    <ScalarVariable {}><{}{}{}/></ScalarVariable>\n",
                      head_of(variable),
                      type_of(variable, "Real"),
                      unit_of(variable),
                      start.empty() ? "" : attribute("start", start));
        if (variable.causality == Causality::output)
          unknowns += fmt::format("      <Unknown index=\"{}\"/>\n", index);
      }
    xml += "  </ModelVariables>\n  <ModelStructure>\n    <Outputs>\n" +
           unknowns + "    </Outputs>\n    <InitialUnknowns>\n" + unknowns +
           "    </InitialUnknowns>\n  </ModelStructure>\n"
           "</fmiModelDescription>\n";
    return xml;
  }

  std::string description_3(const DescriptionText &text)
  {
    std::string xml =
      declaration + ("<fmiModelDescription fmiVersion=\"3.0\"" +
                     model_of(text, "instantiationToken") + ">\n");
    xml += fmt::format("  <CoSimulation modelIdentifier=\"{}\"{} "
                       "canHandleVariableCommunicationStepSize=\"true\" "
                       "canBeInstantiatedOnlyOncePerProcess=\"false\" "
                       "canGetAndSetFMUState=\"true\" "
                       "canSerializeFMUState=\"true\"/>\n",
                       model_name,
                       tool_of(text.kind));
    xml += units_text() + log_categories(text.kind) + experiment_of(text) +
           "  <ModelVariables>\n";
    std::string outputs, unknowns;
    for (const Variable &variable : variables(text.kind))
      {
        const std::string start   = start_of(variable, text);
        const char       *type    = type_of(variable, "Float64");
        const bool        is_text = variable.type == VariableType::text;
        xml += fmt::format("    <{} {}{}",
                           type,
                           head_of(variable),
                           unit_of(variable));
        if (is_text)
          xml +=
            fmt::format("><Start{}/></{}>\n", attribute("value", start), type);
        else
          xml += (start.empty() ? "" : attribute("start", start)) + "/>\n";
        if (variable.causality != Causality::output)
          continue;
        outputs += fmt::format("    <Output valueReference=\"{}\"/>\n",
                               variable.reference);
        unknowns += fmt::format("    <InitialUnknown valueReference=\"{}\"/>\n",
                                variable.reference);
      }
    return xml + "  </ModelVariables>\n  <ModelStructure>\n" + outputs +
           unknowns + "  </ModelStructure>\n</fmiModelDescription>\n";
  }

  std::string token_of(const std::string &bytes)
  {
    const std::uint64_t prime = 1099511628211u;
    std::uint64_t first = 14695981039346656037u, second = first ^ 0x5bd1e995u;
    for (const unsigned char byte : bytes)
      {
        first  = (first ^ byte) * prime;
        second = (second ^ byte ^ (first >> 56)) * prime;
      }
    const std::string digits = fmt::format("{:016x}{:016x}", first, second);
    return '{' + digits.substr(0, 8) + '-' + digits.substr(8, 4) + '-' +
           digits.substr(12, 4) + '-' + digits.substr(16, 4) + '-' +
           digits.substr(20) + '}';
  }
} // namespace RollingContact::Fmu
