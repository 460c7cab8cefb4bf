class store::web (
  Integer $port = 8080,
  String  $owner = 'www',
) {
  package { 'nginx': ensure => installed }
  file { '/srv/x10':
    ensure => directory,
    owner  => $owner,
    mode   => '0755',
  }
  service { 'nginx':
    ensure  => running,
    require => Package['nginx'],
  }
}
