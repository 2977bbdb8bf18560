# One image for web, worker and migrations; `soundlist` is on its PATH.
FROM node:22-bookworm-slim AS page
WORKDIR /src/frontend
COPY frontend/package.json frontend/package-lock.json frontend/.npmrc ./
RUN npm ci
COPY frontend ./
COPY docs/checks /src/docs/checks
RUN npm run build

FROM python:3.13-slim-bookworm
RUN apt-get update && apt-get install -y --no-install-recommends gcc libc6-dev && rm -rf /var/lib/apt/lists/*
WORKDIR /srv/soundlist
COPY pyproject.toml setup.py MANIFEST.in constraints.txt README.md LICENSE ./
COPY audio_checks ./audio_checks
RUN pip install --no-cache-dir --constraint constraints.txt '.[server]' && rm -rf audio_checks build
COPY app ./app
COPY migrations ./migrations
COPY --from=page /src/frontend/dist ./frontend/dist
RUN printf '#!/bin/sh\ncd /srv/soundlist && exec python -m app "$@"\n' > /usr/local/bin/soundlist \
    && chmod +x /usr/local/bin/soundlist \
    && useradd --system --create-home soundlist && mkdir /data && chown soundlist /data
USER soundlist
ENV SOUNDLIST_DATA_DIR=/data
VOLUME /data
EXPOSE 8000
CMD ["soundlist", "serve", "--host", "0.0.0.0"]
