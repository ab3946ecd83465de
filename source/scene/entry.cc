#include <fmt/format.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/entry.h>
#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    std::string why_idle(const std::vector<Reader> &readers,
                         const SceneParameters     &scene)
    {
      for (const Reader &reader : readers)
        if (!reader.reads(scene))
          return reader.otherwise;
      return "";
    }

    /** "`a`, `b` or `c`" from "a|b|c". */
    std::string choices_in_words(const std::string &names)
    {
      std::string text = '`' + names + '`';
      for (std::size_t bar = text.rfind('|'); bar != std::string::npos;
           bar             = text.rfind('|'))
        text.replace(bar,
                     1,
                     text.find(" or ", bar) == std::string::npos ? "` or `"
                                                                             : "`, `");
      return text;
    }
  } // namespace

  Reader scenes_in_3d()
  {
    return {[](const SceneParameters &scene) { return scene.dimension == 3; },
            "it has a meaning in 3D only"};
  }

  Reader scenes_with_spectra()
  {
    return {[](const SceneParameters &scene) { return scene.wants_spectra(); },
            "no surface moves, no vibration is excited and no points are "
            "named; take Spectrum/Write = always"};
  }

  template <class Part>
  const Part &part_of(const SceneParameters &scene)
  {
    return std::get<const Part &>(std::tie(scene.analysis,
                                           scene.contact,
                                           scene.mesh,
                                           scene.study,
                                           scene.time,
                                           scene.surfaces,
                                           scene.spectrum,
                                           scene.sound,
                                           scene.profiles,
                                           scene.wear));
  }

  template const AnalysisTraits     &part_of(const SceneParameters &);
  template const ContactParameters  &part_of(const SceneParameters &);
  template const MeshParameters     &part_of(const SceneParameters &);
  template const StudyParameters    &part_of(const SceneParameters &);
  template const TimeParameters     &part_of(const SceneParameters &);
  template const SurfaceParameters  &part_of(const SceneParameters &);
  template const SpectrumParameters &part_of(const SceneParameters &);
  template const SoundParameters    &part_of(const SceneParameters &);
  template const ProfileParameters  &part_of(const SceneParameters &);
  template const WearParameters     &part_of(const SceneParameters &);

  Reader analyses_with_elements()
  {
    return {[](const SceneParameters &scene) {
              return scene.analysis.has_bodies;
            },
            "an analysis with finite elements reads that section"};
  }

  Reader analyses_of_contact()
  {
    return {[](const SceneParameters &scene) {
              return !scene.analysis.has_lone_bodies();
            },
            "an analysis of contact reads that section"};
  }

  bool place_is_found(const SceneParameters &scene)
  {
    return scene.finds_place();
  }

  EntrySection &EntrySection::read_by_analyses(const std::string &names)
  {
    return read_by({[section = name](const SceneParameters &scene) {
                      return scene.analysis.reads(section);
                    },
                    "Analysis = " + names + " reads that section"});
  }

  EntrySection &
  EntrySection::read_with_reduced_bodies(const std::string &otherwise)
  {
    return read_by({[section = name](const SceneParameters &scene) {
                      return scene.analysis.reads(section) ||
                             scene.has_reduced_bodies();
                    },
                    otherwise});
  }

  std::string EntrySection::why_idle(const SceneParameters &scene) const
  {
    return RollingContact::why_idle(readers, scene);
  }

  Entry &Entry::at_least(const double bound)
  {
    lower = bound;
    return *this;
  }

  Entry &Entry::between(const double lower, const double upper)
  {
    this->lower = lower;
    this->upper = upper;
    return *this;
  }

  Entry &Entry::one_of(const std::string &names)
  {
    this->names = names;
    return *this;
  }

  Entry &Entry::several(const unsigned int least)
  {
    this->least = least;
    return *this;
  }

  Entry &Entry::or_empty()
  {
    word = "";
    read = [given = read, empty = default_text](const std::string &text) {
      given(text.empty() ? empty : text);
    };
    return *this;
  }

  Entry &Entry::or_word(const std::string &word)
  {
    this->word = word;
    return *this;
  }

  Entry &Entry::read_by(const Reader &reader)
  {
    readers.push_back(reader);
    return *this;
  }

  Entry &Entry::read_by(const std::vector<Reader> &more)
  {
    readers.insert(readers.end(), more.begin(), more.end());
    return *this;
  }

  Entry &Entry::renewing(const Renews what)
  {
    renews = what;
    return *this;
  }

  Entry &Entry::resumed_if(const SceneCondition &condition)
  {
    free_on_resume = condition;
    return *this;
  }

  std::string Entry::path() const
  {
    return section->name.empty() ? name : section->name + '/' + name;
  }

  std::string Entry::why_idle(const SceneParameters &scene) const
  {
    return RollingContact::why_idle(readers, scene);
  }

  std::string Entry::allowed() const
  {
    if (!names.empty())
      return (least ? "a list separated by commas, each " : "") +
             choices_in_words(names);
    if (kind == Kind::flag)
      return "`true` or `false`";
    if (kind != Kind::integer && kind != Kind::number)
      return "";
    const bool is_from       = lower > std::numeric_limits<double>::lowest(),
               is_to         = upper < std::numeric_limits<double>::max();
    const std::string behind = unit == "1" || unit.empty() ? "" : ' ' + unit,
                      range =
                        is_from && is_to
                          ? fmt::format(" from {:g} to {:g}", lower, upper)
                        : is_from ? fmt::format(" of at least {:g}", lower)
                        : is_to   ? fmt::format(" of at most {:g}", upper)
                        : behind.empty() ? ""
                                         : " in";
    return std::string(least ? "a list separated by commas, each " : "") +
           (kind == Kind::integer ? "a whole number" : "a number") + range +
           behind +
           (!word           ? ""
            : word->empty() ? ", or leave it empty"
                            : ", or `" + *word + '`');
  }

  std::unique_ptr<Patterns::PatternBase> Entry::pattern() const
  {
    // deal.II has no pattern of either; check() looks at the value
    return word ? std::make_unique<Patterns::Anything>() : value_pattern();
  }

  std::unique_ptr<Patterns::PatternBase> Entry::value_pattern() const
  {
    std::unique_ptr<Patterns::PatternBase> value;
    if (!names.empty())
      value = std::make_unique<Patterns::Selection>(names);
    else if (kind == Kind::flag)
      value = std::make_unique<Patterns::Bool>();
    else if (kind == Kind::integer)
      value = std::make_unique<Patterns::Integer>(
        lower, std::min<double>(upper, std::numeric_limits<int>::max()));
    else if (kind == Kind::number)
      value = std::make_unique<Patterns::Double>(lower, upper);
    else
      value = std::make_unique<Patterns::Anything>();
    if (least)
      return std::make_unique<Patterns::List>(*value, *least);
    return value;
  }

  void Entry::check(const std::string &value, const std::string &place) const
  {
    if (value == word || value_pattern()->match(value))
      return;
    const bool has_decimal_comma =
      kind == Kind::number && !least && value.find(',') != std::string::npos &&
      value.find_first_not_of("0123456789.,eE+-") == std::string::npos;
    throw InputError(place + path() + " = " + quotable(value) + ": give " +
                     allowed() +
                     (has_decimal_comma ? "; decimals take a point." : "."));
  }

  bool Entry::is_default(const std::string &value) const
  {
    if (value == default_text || value == word)
      return true;
    const auto given = number(value), by_default = number(default_text);
    return given && by_default && *given == *by_default;
  }

  bool Entry::takes_numbers() const
  {
    return kind == Kind::numbers ||
           (!least && (kind == Kind::integer || kind == Kind::number));
  }

  std::string Entry::documentation() const
  {
    return unit.empty() ? help : help + " Units: " + unit + '.';
  }
} // namespace RollingContact
