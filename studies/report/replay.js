// The interactive replay of a report: rotate, zoom, scrub the time, colour by a field.
// Needs `THREE` with its OrbitControls; the data are in window.zonaReplay.
"use strict";

(function () {
  // Lightness rises, so that it also reads in grey.
  const RAMP = [[0.16, 0.18, 0.45], [0.14, 0.45, 0.6], [0.3, 0.68, 0.5], [0.75, 0.82, 0.3], [0.99, 0.9, 0.45]];
  const PLAIN = { zona: [0.93, 0.8, 0.62], pipette: [0.6, 0.66, 0.72], plate: [0.45, 0.6, 0.8] };
  const FAILED = [0.8, 0.07, 0.1];
  const UNITS = { strain: "", damage: "", failed: "", speed: " m/s", pressure: " Pa" };

  function bytes(text) {
    const binary = atob(text);
    const array = new Uint8Array(binary.length);
    for (let i = 0; i < binary.length; ++i) array[i] = binary.charCodeAt(i);
    return array;
  }

  function ramp(share) {
    const at = Math.min(Math.max(share, 0), 1) * (RAMP.length - 1);
    const below = Math.min(Math.floor(at), RAMP.length - 2);
    return RAMP[below].map((c, i) => c + (at - below) * (RAMP[below + 1][i] - c));
  }

  function timeText(seconds) {
    if (seconds >= 1) return seconds.toPrecision(4) + " s";
    return seconds >= 1e-3 ? (1e3 * seconds).toPrecision(4) + " ms" : (1e6 * seconds).toFixed(2) + " \u00b5s";
  }

  function element(tag, parent, properties) {
    const made = Object.assign(document.createElement(tag), properties || {});
    parent.appendChild(made);
    return made;
  }

  class Body {
    constructor(data, run) {
      this.data = data;
      this.run = run;
      this.cache = new Map();
      const geometry = new THREE.BufferGeometry();
      this.position = new THREE.BufferAttribute(new Float32Array(3 * data.points), 3);
      this.colour = new THREE.BufferAttribute(new Float32Array(3 * data.points), 3);
      geometry.setAttribute("position", this.position);
      geometry.setAttribute("color", this.colour);
      if (data.triangles) {
        const triangles = bytes(data.triangles);
        geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(triangles.buffer), 1));
        const material = new THREE.MeshPhongMaterial({
          vertexColors: THREE.VertexColors, side: THREE.DoubleSide, shininess: 25, specular: 0x333333 });
        this.object = new THREE.Mesh(geometry, material);
      } else {
        const size = 0.8 * run.spacing(data);
        this.object = new THREE.Points(geometry, new THREE.PointsMaterial({
          vertexColors: THREE.VertexColors, size: size, sizeAttenuation: true }));
      }
      this.object.frustumCulled = false;
    }

    numbers(list, frame, kind) {
      const key = list.name + frame;
      if (!this.cache.has(key)) {
        const raw = bytes(list.values[frame]);
        this.cache.set(key, kind === 16 ? new Uint16Array(raw.buffer) : raw);
      }
      return this.cache.get(key);
    }

    show(frame, field) {
      const low = this.run.data.low, high = this.run.data.high;
      const places = this.numbers({ name: "places", values: this.data.places }, frame, 16);
      const at = this.position.array;
      const scale = this.run.scale / 65535;
      for (let i = 0; i < at.length; ++i) at[i] = scale * places[i] * (high[i % 3] - low[i % 3]);
      this.position.needsUpdate = true;
      this.paint(frame, field);
      if (this.data.triangles) this.object.geometry.computeVertexNormals();
    }

    paint(frame, field) {
      const shown = this.data.fields[field];
      const failed = this.data.fields.failed;
      const plain = PLAIN[this.data.name] || [0.55, 0.72, 0.86];
      const values = shown && this.numbers(Object.assign({ name: field }, shown), frame, 8);
      const holes = failed && this.numbers(Object.assign({ name: "failed" }, failed), frame, 8);
      const out = this.colour.array;
      for (let p = 0; p < this.data.points; ++p) {
        let c = plain;
        if (holes && failed.high > 0 && holes[p] > 127) c = FAILED;
        else if (values && field !== "failed") c = ramp(values[p] / 255);
        out.set(c, 3 * p);
      }
      this.colour.needsUpdate = true;
    }
  }

  class Run {
    /// Scaled to a length of 100 units, with its lowest corner at the origin.
    constructor(data) {
      this.data = data;
      this.size = data.high.map((h, i) => h - data.low[i]);
      this.scale = 100 / Math.max(...this.size);
      this.bodies = data.bodies.map((body) => new Body(body, this));
    }
    spacing(body) {
      const volume = this.size.reduce((v, s) => v * Math.max(s * this.scale, 1), 1);
      return Math.cbrt(volume / Math.max(body.points, 1)) * (body.points < 3000 ? 0.35 : 0.6);
    }
  }

  function build(place, runs) {
    const canvas = element("canvas", place);
    let renderer;
    try {
      renderer = new THREE.WebGLRenderer({ canvas: canvas, antialias: true, preserveDrawingBuffer: true });
    } catch (error) {
      place.textContent = "This browser does not draw in 3D (WebGL is missing).";
      return;
    }
    renderer.setPixelRatio(window.devicePixelRatio);
    renderer.setClearColor(0xffffff);
    const camera = new THREE.PerspectiveCamera(35, 1, 0.1, 1e4);
    camera.up.set(0, 0, 1);
    const controls = new THREE.OrbitControls(camera, canvas);
    const bar = element("div", place, { className: "controls" });
    const play = element("button", bar, { textContent: "Play", type: "button" });
    const slider = element("input", bar, { type: "range", min: 0, value: 0 });
    slider.setAttribute("aria-label", "time");
    const clock = element("span", bar);
    const chooser = element("select", bar);
    chooser.setAttribute("aria-label", "run");
    const colour = element("select", bar);
    colour.setAttribute("aria-label", "colour by");
    const scale = element("span", bar);
    const toggles = element("span", bar);
    runs.forEach((run, i) => element("option", chooser, { value: i, textContent: run.name || "run" }));
    chooser.hidden = runs.length < 2;

    let scene, run, timer = null;
    const loaded = new Map();

    function draw() { renderer.render(scene, camera); }

    function resize() {
      const width = canvas.clientWidth, height = canvas.clientHeight;
      renderer.setSize(width, height, false);
      camera.aspect = width / height;
      camera.updateProjectionMatrix();
      if (scene) draw();
    }

    function legend() {
      const ranges = run.data.bodies.map((b) => b.fields[colour.value]).filter(Boolean);
      scale.textContent = "";
      if (!ranges.length || colour.value === "failed") { scale.textContent = "failed points red"; return; }
      // Bodies have scales of their own; what is shown is that of the first that has the field.
      const stops = RAMP.map((c) => "rgb(" + c.map((v) => Math.round(255 * v)).join(",") + ")").join(",");
      scale.append(ranges[0].low.toPrecision(3) + UNITS[colour.value]);
      element("span", scale, { className: "scale" }).style.background = "linear-gradient(90deg," + stops + ")";
      scale.append(ranges[0].high.toPrecision(3) + UNITS[colour.value] + ", failed points red");
    }

    function show() {
      const frame = Number(slider.value);
      run.bodies.forEach((body) => body.object.visible && body.show(frame, colour.value));
      clock.textContent = timeText(run.data.times[frame]);
      draw();
    }

    function choose(index) {
      if (!loaded.has(index)) loaded.set(index, new Run(runs[index].data));
      const first = !run;
      run = loaded.get(index);
      scene = new THREE.Scene();
      scene.add(new THREE.AmbientLight(0xffffff, 0.55));
      const light = new THREE.DirectionalLight(0xffffff, 0.6);
      camera.add(light);
      scene.add(camera);
      run.bodies.forEach((body) => scene.add(body.object));
      if (first) {
        const middle = run.size.map((s) => run.scale * s / 2);
        controls.target.set(...middle);
        camera.position.set(middle[0] + 90, middle[1] - 125, middle[2] + 75);
        const names = new Set(run.data.bodies.flatMap((b) => Object.keys(b.fields)));
        ["failed", "strain", "damage", "speed", "pressure"].filter((n) => names.has(n)).forEach(
          (n) => element("option", colour, { value: n, textContent: n === "failed" ? "failed only" : n }));
        if (names.has("strain")) colour.value = "strain";
        controls.update();
      }
      toggles.textContent = "";
      run.bodies.forEach((body) => {
        if (first) body.object.visible = Boolean(body.data.triangles) || !("pressure" in body.data.fields) ||
          !run.data.bodies.some((b) => b.triangles);
        const label = element("label", toggles);
        const box = element("input", label, { type: "checkbox", checked: body.object.visible });
        label.append(body.data.name + (body.data.points < body.data.of ?
          " (" + body.data.points + " of " + body.data.of + " points) " : " "));
        box.addEventListener("change", () => { body.object.visible = box.checked; show(); });
      });
      slider.max = run.data.times.length - 1;
      if (first) slider.value = slider.max;
      legend();
      show();
    }

    function stop() { clearInterval(timer); timer = null; play.textContent = "Play"; }

    play.addEventListener("click", () => {
      if (timer) { stop(); return; }
      play.textContent = "Stop";
      timer = setInterval(() => {
        slider.value = (Number(slider.value) + 1) % run.data.times.length;
        show();
      }, 200);
    });
    slider.addEventListener("input", () => { stop(); show(); });
    colour.addEventListener("change", () => { legend(); show(); });
    chooser.addEventListener("change", () => choose(Number(chooser.value)));
    controls.addEventListener("change", draw);
    window.addEventListener("resize", resize);
    resize();
    choose(0);
    resize();
  }

  document.querySelectorAll(".replay").forEach((place) => build(place, window.zonaReplay));
})();
