# The program on Debian 12, without tests and report:
#   docker build -t pulloff .
#   docker run --rm -v "$PWD:/here" -w /here pulloff solve --tabor 1
FROM debian:12 AS build
COPY . /pulloff
RUN apt-get update && apt-get install -y --no-install-recommends $(grep -v '^#' /pulloff/tools/packages)
RUN meson setup /pulloff/build-image /pulloff -Dtests=false --prefix=/opt/pulloff && meson install -C /pulloff/build-image

FROM debian:12
RUN apt-get update && apt-get install -y --no-install-recommends libgsl27 liblapacke libopenblas0-pthread libyaml-0-2 libjansson4 \
    libnettle8 libgomp1 gnuplot-nox && rm -rf /var/lib/apt/lists/*
COPY --from=build /opt/pulloff /opt/pulloff
ENV PATH=/opt/pulloff/bin:$PATH
ENTRYPOINT ["pulloff"]
