# Sourced by scripts that install packages of Debian.

install_packages() { # installs packages of Debian one by one, because some may not exist
  local package missing=() sudo=()
  for package in "$@"; do
    [[ "$(dpkg-query -W -f='${db:Status-Abbrev}' "$package" 2> /dev/null)" == ii* ]] ||
      missing+=("$package")
  done
  [[ ${#missing[@]} -gt 0 ]] || return 0
  [[ $EUID -eq 0 ]] || sudo=(sudo)
  "${sudo[@]}" apt-get update -qq || true
  for package in "${missing[@]}"; do
    "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq \
      --no-install-recommends --no-remove "$package" > /dev/null ||
      echo "${0#./}: apt does not install $package" >&2
  done
}
