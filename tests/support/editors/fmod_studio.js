// Runs a script of FMOD Studio: the documented calls that it makes, over a project in memory, and no others.
//
//     node fmod_studio.js SCRIPT FOLDER [RUNS] [CHANGES]
//     node fmod_studio.js listen FOLDER
//
// "listen" is the script server: it prints its port, evaluates each line that it is sent, and answers in text; a dialog
// would wait for a person, so it is an error there.
// FOLDER is the project's. The menu item of the script is executed RUNS times. CHANGES is JavaScript run after the first.
// Answers as JSON: for each run the number of changes and what was shown, and the events at the end.
"use strict"
const fs = require("fs")
const path = require("path")
const vm = require("vm")

const [script, folder, runs = "1", between = ""] = process.argv.slice(2)
const BASES = { Event: ["EventFolder"], AudioFile: ["Asset"], SingleSound: ["Sound"], MultiSound: ["Sound"] }
let changes = 0
let ids = 0

// An object of the project: reading or writing what the documents do not name is an error.
function strict(kind, values, readOnly = []) {
  const known = { entity: kind, ...values }
  return new Proxy(known, {
    get(target, name) {
      if (typeof name === "symbol" || name === "toJSON") return undefined
      if (!(name in target)) throw new Error(`${kind}.${name} is not documented`)
      return target[name]
    },
    set(target, name, value) {
      if (!(name in target) || readOnly.includes(name)) throw new Error(`${kind}.${name} cannot be set`)
      target[name] = value
      changes += 1
      return true
    },
  })
}

function managed(kind, values = {}, readOnly = []) {
  const object = strict(
    kind,
    {
      id: `{${++ids}}`,
      isOfType: (name) => name === kind || (BASES[kind] || []).includes(name),
      isOfExactType: (name) => name === kind,
      ...values,
    },
    ["id", ...readOnly],
  )
  changes += 1
  return object
}

const audioFiles = []
const folders = []
const events = []
const masterEventFolder = strict("MasterEventFolder", { name: "", folder: null })

function pathOf(item) {
  const parts = []
  for (let at = item; at && at !== masterEventFolder; at = at.folder) parts.unshift(at.name)
  return `event:/${parts.join("/")}`
}

function single(more = {}) {
  const object = managed("SingleSound", { audioFile: null, owner: null, ...more })
  return new Proxy(object, {
    set(target, name, value) {
      if (name === "owner") value.sounds.push(object)
      target[name] = value
      return true
    },
  })
}

function groupTrack(name) {
  const modules = []
  return managed("GroupTrack", {
    name,
    modules,
    addSound(parameter, kind, start, length) {
      if (parameter.entity !== "Timeline") throw new Error("a sound stands on a parameter of its event")
      if (!(start >= 0) || !(length > 0)) throw new Error(`a sound of ${length} s at ${start} s`)
      if (kind !== "SingleSound" && kind !== "MultiSound") throw new Error(`${kind} is not a sound`)
      const sound = kind === "SingleSound" ? single({ start, length }) : managed(kind, { sounds: [], start, length })
      modules.push(sound)
      return sound
    },
  })
}

function markerTrack() {
  const markers = []
  return managed("MarkerTrack", {
    markers,
    addRegion(position, length, name, loopMode) {
      if (typeof name !== "string" || loopMode !== 1) throw new Error("addRegion(position, length, name, loopMode)")
      if (!(position >= 0) || !(length > 0)) throw new Error(`a region of ${length} s at ${position} s`)
      markers.push(managed("LoopRegion", { position, length, name, looping: true }))
      return markers[markers.length - 1]
    },
  })
}

function event() {
  const groupTracks = []
  const markerTracks = []
  const made = managed("Event", {
    name: "New Event",
    folder: masterEventFolder,
    note: "",
    timeline: strict("Timeline", {}),
    groupTracks,
    markerTracks,
    addGroupTrack(name) {
      groupTracks.push(groupTrack(name))
      return groupTracks[groupTracks.length - 1]
    },
    addMarkerTrack() {
      markerTracks.push(markerTrack())
      return markerTracks[markerTracks.length - 1]
    },
  })
  events.push(made)
  return made
}

const menu = []
const studio = strict("studio", {
  menu: strict("menu", { addMenuItem: (item) => menu.push(strict("MenuItem", item)) }),
  system: strict("system", {
    openMode: strict("openMode", { NotOpen: 0, ReadOnly: 1, WriteOnly: 2 }),
    getFile(name) {
      let isOpen = false
      return strict("File", {
        exists: () => fs.existsSync(name),
        open: (mode) => (isOpen = mode === 1),
        size: () => fs.statSync(name).size,
        readText(size) {
          if (!isOpen) throw new Error("the file is not open")
          return fs.readFileSync(name).toString("latin1").slice(0, size)
        },
        close: () => (isOpen = false),
      })
    },
  }),
  project: strict("project", {
    filePath: path.join(folder, "Game.fspro"),
    regionLoopMode: strict("regionLoopMode", { None: 0, Looping: 1, Magnet: 2 }),
    workspace: strict("Workspace", {
      masterEventFolder,
      masterAssetFolder: strict("MasterAssetFolder", {
        getAsset: (name) => audioFiles.find((file) => file.assetPath === name),
      }),
    }),
    lookup: (name) => [...folders, ...events].find((item) => pathOf(item) === name),
    create(kind) {
      if (kind === "Event") return event()
      if (kind === "SingleSound") return single()
      if (kind !== "EventFolder") throw new Error(`create("${kind}")`)
      folders.push(managed(kind, { name: "New Folder", folder: masterEventFolder, note: "" }))
      return folders[folders.length - 1]
    },
    importAudioFile(name) {
      if (!fs.existsSync(name)) return null
      const inside = path.relative(path.join(folder, "Assets"), name)
      const assetPath = inside.startsWith("..") ? path.basename(name) : inside
      audioFiles.push(managed("AudioFile", { assetPath, isStreaming: false, length: 1 }, ["assetPath", "length"]))
      return audioFiles[audioFiles.length - 1]
    },
  }),
})

if (script === "listen") {
  const alert = () => {
    throw new Error("a dialog waits for a person")
  }
  const console = vm.createContext({ studio, alert })
  const server = require("net").createServer((client) => {
    client.on("error", () => {})
    client.write("log(): Connected to FMOD Studio on 127.0.0.1.\n")
    let received = ""
    client.on("data", (block) => {
      received += block
      for (let end = received.indexOf("\n"); end >= 0; end = received.indexOf("\n")) {
        const line = received.slice(0, end)
        received = received.slice(end + 1)
        let answer
        try {
          answer = `out(): ${vm.runInContext(line, console, { timeout: 10000 })}`
        } catch (error) {
          answer = `err(): ${error.message}`
        }
        client.write(`${line}\n`)
        for (let at = 0; at < answer.length; at += 7) client.write(answer.slice(at, at + 7))
        client.write(`\nlog(): ${events.length} events\n`)
      }
    })
  })
  server.listen(0, "127.0.0.1", () => process.stdout.write(`${server.address().port}\n`))
  return
}
const shown = []
const context = vm.createContext({ studio, alert: (text) => shown.push(text) })
vm.runInContext(fs.readFileSync(script, "utf8"), context, { timeout: 10000 })
const executed = []
for (let run = 0; run < Number(runs); run++) {
  changes = 0
  for (const item of menu) item.execute()
  executed.push({ changes, shown: shown.splice(0).join("\n") })
  if (run === 0 && between) new Function("events", "audioFiles", "folders", between)(events, audioFiles, folders)
}
const assetOf = (sound) => sound.audioFile.assetPath
const described = events.map((made) => ({
  path: pathOf(made),
  note: made.note,
  assets: made.groupTracks.flatMap((track) =>
    track.modules.flatMap((module) => (module.entity === "MultiSound" ? module.sounds.map(assetOf) : [assetOf(module)])),
  ),
  loops: made.markerTracks.flatMap((track) => track.markers.map(({ position, length }) => [position, length])),
}))
const streamed = audioFiles.filter((file) => file.isStreaming).map((file) => file.assetPath)
process.stdout.write(JSON.stringify({ menu: menu.map((item) => item.name), runs: executed, events: described, streamed }))
