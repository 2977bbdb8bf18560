# One image for web, worker, migrations and backups; `soundlist` is on its PATH.
FROM node:22-trixie-slim AS page
WORKDIR /src/frontend
COPY frontend/package.json frontend/package-lock.json frontend/.npmrc ./
RUN npm ci
COPY frontend ./
COPY docs/checks /src/docs/checks
RUN npm run build

# Both wheels are built here, so that what runs has neither compiler nor sources. Nothing is installed that the lock does
# not name, with its hash. tests/house/test_image.py runs the commands of this stage where there are no containers.
FROM python:3.13-slim-trixie AS packages
RUN apt-get update && apt-get install -y --no-install-recommends gcc libc6-dev && rm -rf /var/lib/apt/lists/*
WORKDIR /src
COPY pyproject.toml uv.lock ./
COPY packages/soundlist/pyproject.toml packages/soundlist/
COPY .ci/locked.py .ci/
RUN python .ci/locked.py uv > build.txt \
    && pip install --no-cache-dir --require-hashes --only-binary :all: --requirement build.txt
ENV UV_COMPILE_BYTECODE=1 UV_NO_CACHE=1 UV_PYTHON_DOWNLOADS=never
RUN UV_PROJECT_ENVIRONMENT=/opt/build uv sync --frozen --no-build --no-install-workspace --only-group build --only-group docs \
    && UV_PROJECT_ENVIRONMENT=/opt/soundlist uv sync --frozen --no-build --no-install-workspace --no-dev --package soundlist
COPY setup.py MANIFEST.in LICENSE ./
COPY packages ./packages
COPY audio_checks ./audio_checks
COPY app ./app
COPY migrations ./migrations
COPY --from=page /src/frontend/dist ./frontend/dist
COPY docs ./docs
COPY zensical.toml ./
COPY .ci/docs_site.py .ci/
RUN /opt/build/bin/python .ci/docs_site.py
# The tag that is checked out, as git describe says it; without it two versions could not be told apart.
ARG VERSION
RUN case "$VERSION" in v[0-9]*) ;; *) \
      echo "VERSION is '$VERSION'; name the tag that is checked out: --build-arg VERSION=\$(git describe --tags)" >&2; exit 1 ;; \
    esac \
    && printf 'describe-name: %s\n' "$VERSION" > .git_archival.txt \
    && uv build --wheel --no-build-isolation --python /opt/build/bin/python --package audio-checks --out-dir /wheels \
    && uv build --wheel --no-build-isolation --python /opt/build/bin/python --package soundlist --out-dir /wheels \
    && uv pip install --python /opt/soundlist/bin/python --no-deps /wheels/*.whl

FROM python:3.13-slim-trixie
# pg_dump and pg_restore, for `soundlist backup` and `soundlist restore`: of no older version than the server. A voice
# for stand-ins and slates, which beep without one.
RUN apt-get update && apt-get install -y --no-install-recommends postgresql-client espeak-ng && rm -rf /var/lib/apt/lists/*
COPY --from=packages /opt/soundlist /opt/soundlist
ENV PATH=/opt/soundlist/bin:$PATH
WORKDIR /srv
RUN useradd --system --uid 10001 --create-home soundlist \
    && mkdir /data /backups && chown soundlist /data /backups
USER 10001
# mallopt(3): by default glibc keeps hundreds of MiB after a few large requests or files at once.
ENV MALLOC_ARENA_MAX=2 MALLOC_MMAP_THRESHOLD_=131072 MALLOC_TRIM_THRESHOLD_=1048576
# librosa's compiled loops must be written somewhere: without a place for them it cannot even be imported.
ENV SOUNDLIST_DATA_DIR=/data PYTHONDONTWRITEBYTECODE=1 PYTHONUNBUFFERED=1 NUMBA_CACHE_DIR=/tmp/numba
VOLUME /data
EXPOSE 8000
HEALTHCHECK --interval=10s --timeout=5s --start-period=30s --retries=3 \
    CMD ["python", "-c", "import urllib.request as r; r.urlopen('http://127.0.0.1:8000/healthz', timeout=3)"]
CMD ["soundlist", "serve", "--host", "0.0.0.0", "--port", "8000"]
