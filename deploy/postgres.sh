#!/bin/sh
# Run by the postgres image, once, where its volume is empty: Soundlist's login owns its database and is not a superuser.
# The superuser keeps no password, so a login as superuser over the network is impossible.
set -eu
psql --no-psqlrc --quiet --set ON_ERROR_STOP=1 --set password="$POSTGRES_PASSWORD" \
  --username "$POSTGRES_USER" --dbname postgres <<'SQL'
create role soundlist login password :'password';
create role soundlist_request nologin;
grant soundlist_request to soundlist;
create database soundlist owner soundlist;
alter role current_user password null;
SQL
