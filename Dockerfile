# One image for web, worker, migrations and backups; `soundlist` is on its PATH.
FROM node:22-trixie-slim AS page
WORKDIR /src/frontend
COPY frontend/package.json frontend/package-lock.json frontend/.npmrc ./
RUN npm ci
COPY frontend ./
COPY docs/checks /src/docs/checks
RUN npm run build

# The compiled kernel is built here, so that what runs has no compiler.
FROM python:3.13-slim-trixie AS packages
RUN apt-get update && apt-get install -y --no-install-recommends gcc libc6-dev && rm -rf /var/lib/apt/lists/*
WORKDIR /src
COPY pyproject.toml uv.lock setup.py MANIFEST.in README.md LICENSE ./
COPY .ci/locked.py .ci/
RUN python .ci/locked.py uv setuptools > build.txt \
    && pip install --no-cache-dir --require-hashes --only-binary :all: --requirement build.txt
ENV UV_PROJECT_ENVIRONMENT=/opt/soundlist UV_COMPILE_BYTECODE=1 UV_NO_CACHE=1 UV_PYTHON_DOWNLOADS=never
RUN uv sync --frozen --no-build --no-install-project --extra server
COPY audio_checks ./audio_checks
RUN pip wheel --no-cache-dir --no-deps --no-build-isolation --wheel-dir /wheels . \
    && uv pip install --python /opt/soundlist/bin/python --no-deps /wheels/*.whl

FROM python:3.13-slim-trixie
# pg_dump and pg_restore, for `soundlist backup` and `soundlist restore`: of no older version than the server. A voice
# for stand-ins and slates, which beep without one.
RUN apt-get update && apt-get install -y --no-install-recommends postgresql-client espeak-ng && rm -rf /var/lib/apt/lists/*
COPY --from=packages /opt/soundlist /opt/soundlist
ENV PATH=/opt/soundlist/bin:$PATH
WORKDIR /srv/soundlist
COPY app ./app
COPY migrations ./migrations
COPY --from=page /src/frontend/dist ./frontend/dist
RUN printf '#!/bin/sh\ncd /srv/soundlist && exec python -m app "$@"\n' > /usr/local/bin/soundlist \
    && chmod +x /usr/local/bin/soundlist \
    && useradd --system --uid 10001 --create-home soundlist \
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
