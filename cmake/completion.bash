# Completion of bash for rolling-contact: scenes, options, entries of --set and
# what they may be, as --print-parameters says.

_rolling_contact_entries() { # Section/Entry or Entry of all parameters
  "$1" --print-parameters 2>/dev/null | awk '
    /^ *subsection / { sub(/^ *subsection /, ""); section = $0 "/" }
    /^ *end$/ { section = "" }
    /^ *set / { sub(/^ *set /, ""); sub(/ *=.*/, ""); print section $0 }'
}

_rolling_contact_choices() { # program, Section/Entry: the default, other words
  "$1" --print-parameters 2>/dev/null | awk -v wanted="$2" '
    /^ *subsection / { sub(/^ *subsection /, ""); section = $0 "/" }
    /^ *end$/ { section = "" }
    /^ *$/ { comment = "" }
    /^ *#/ { sub(/^ *# */, ""); comment = comment " " $0; next }
    /^ *set / {
      name = value = $0
      sub(/^ *set /, "", name); sub(/ *=.*/, "", name); sub(/^[^=]*= */, "", value)
      if (section name != wanted) next
      if (value != "") print value
      if (value == "true") print "false"
      else if (value == "false") print "true"
      else if (value ~ /^[a-zA-Z]/) { # choices stand between backticks
        n = split(comment, part, "`")
        for (i = 2; i <= n; i += 2)
          if (part[i] != value && part[i] ~ /^[a-z][a-z0-9 -]*$/) print part[i]
      }
    }'
}

_rolling_contact() {
  local program=${COMP_WORDS[0]} word previous IFS=$'\n'
  _get_comp_words_by_ref -n "=:" -c cur -p previous 2>/dev/null || {
    cur=${COMP_WORDS[COMP_CWORD]}
    previous=${COMP_WORDS[COMP_CWORD - 1]}
  }
  word=${cur#[\"\']}
  COMPREPLY=()
  case $previous in
    --output)
      compopt -o filenames
      mapfile -t COMPREPLY < <(compgen -d -- "$word")
      return ;;
    --set)
      compopt -o nospace
      if [[ $word == *=* ]]; then
        mapfile -t COMPREPLY < <(_rolling_contact_choices "$program" "${word%%=*}" |
          sed "s|^|${word%%=*}=|" | grep -F -- "$word")
      else
        mapfile -t COMPREPLY < <(_rolling_contact_entries "$program" | sed 's/$/=/' |
          grep "^$word")
      fi
      # within quotes the words stay as they are, without they are quoted
      if [[ $cur != [\"\']* ]]; then
        mapfile -t COMPREPLY < <(printf '%q\n' "${COMPREPLY[@]}" | grep -v "^''$")
      fi
      return ;;
  esac
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W $'--set\n--output\n--resume\n--validate\n--print-parameters\n--parameters-as-json\n--version\n--help' -- "$word")
    return
  fi
  compopt -o filenames
  mapfile -t COMPREPLY < <(compgen -f -X '!*.prm' -- "$word"; compgen -d -- "$word")
}

complete -F _rolling_contact rolling-contact
