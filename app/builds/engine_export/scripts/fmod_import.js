// Makes events of the sounds of a Soundlist pack, in FMOD Studio 2.02 and later.
//
// Unpack the pack beside the project's .fspro file, restart the project or choose Scripts > Reload, then
// Scripts > Soundlist > Import pack. What exists is left as it is; nothing is saved by the script.
(function () {
    "use strict";

    var DOCUMENT = "soundlist-handoff.json";
    var FORMAT = 1;
    var ASSETS = "Assets/";

    function projectFolder() {
        var path = studio.project.filePath.replace(/\\/g, "/");
        return path.substring(0, path.lastIndexOf("/"));
    }

    function readSounds(folder) {
        var file = studio.system.getFile(folder + "/" + DOCUMENT);
        if (!file.exists()) {
            throw new Error(DOCUMENT + " is not beside the project file. Unpack the pack there.");
        }
        file.open(studio.system.openMode.ReadOnly);
        var text = file.readText(file.size());
        file.close();
        var content = JSON.parse(text);
        if (content.format !== FORMAT) {
            throw new Error(DOCUMENT + " is of format " + content.format + ", this script reads " + FORMAT + ".");
        }
        return content.sounds;
    }

    function folderAt(parts, report) {
        var parent = studio.project.workspace.masterEventFolder;
        for (var depth = 1; depth <= parts.length; depth++) {
            var path = "event:/" + parts.slice(0, depth).join("/");
            var folder = studio.project.lookup(path);
            if (!folder) {
                folder = studio.project.create("EventFolder");
                folder.name = parts[depth - 1];
                folder.folder = parent;
                report.folders += 1;
            } else if (!folder.isOfExactType("EventFolder")) {
                throw new Error(path + " is no folder.");
            }
            parent = folder;
        }
        return parent;
    }

    function assetPath(file) {
        return file.path.indexOf(ASSETS) === 0 ? file.path.substring(ASSETS.length) : file.path.split("/").pop();
    }

    function assetOf(folder, sound, file, report) {
        var known = studio.project.workspace.masterAssetFolder.getAsset(assetPath(file));
        if (known) {
            if (file.path.indexOf(ASSETS) !== 0) {
                report.notReplaced += 1;
            }
            return known;
        }
        var asset = studio.project.importAudioFile(folder + "/" + file.path);
        if (!asset) {
            throw new Error(file.path + " could not be imported. Is it beside the project file?");
        }
        if (sound.streamed) {
            asset.isStreaming = true;
        }
        report.assets += 1;
        return asset;
    }

    function addToPlaylist(playlist, asset) {
        var single = studio.project.create("SingleSound");
        single.audioFile = asset;
        single.owner = playlist;
    }

    function longest(sound) {
        return sound.files.reduce(function (length, file) {
            return Math.max(length, file.duration_s);
        }, 0);
    }

    function create(sound, assets, report) {
        var parts = sound.event_path;
        var folder = folderAt(parts.slice(0, -1), report);
        var event = studio.project.create("Event");
        event.name = parts[parts.length - 1];
        event.folder = folder;
        event.note = sound.notes;
        var track = event.addGroupTrack("Audio");
        if (assets.length === 1) {
            track.addSound(event.timeline, "SingleSound", 0, longest(sound)).audioFile = assets[0];
        } else {
            var playlist = track.addSound(event.timeline, "MultiSound", 0, longest(sound));
            assets.forEach(function (asset) {
                addToPlaylist(playlist, asset);
            });
        }
        if (sound.loop) {
            var first = sound.files[0];
            var only = assets.length === 1;
            var start = only ? first.loop_start_s : 0;
            var end = only ? first.loop_end_s : longest(sound);
            event.addMarkerTrack().addRegion(start, end - start, "loop", studio.project.regionLoopMode.Looping);
        }
        report.events += 1;
    }

    // Adds the variations that a set lacks; anything else that differs is the work of the project and is only named.
    function update(event, path, assets, report) {
        var playlists = [];
        var used = [];
        event.groupTracks.forEach(function (track) {
            track.modules.forEach(function (module) {
                if (module.isOfType("MultiSound")) {
                    playlists.push(module);
                    module.sounds.forEach(function (sound) {
                        if (sound.isOfType("SingleSound") && sound.audioFile) {
                            used.push(sound.audioFile.id);
                        }
                    });
                } else if (module.isOfType("SingleSound") && module.audioFile) {
                    used.push(module.audioFile.id);
                }
            });
        });
        var missing = assets.filter(function (asset) {
            return used.indexOf(asset.id) < 0;
        });
        if (missing.length > 0 && playlists.length === 1) {
            missing.forEach(function (asset) {
                addToPlaylist(playlists[0], asset);
            });
            report.variations += missing.length;
        } else if (missing.length > 0) {
            report.different.push(path);
        }
    }

    function importSound(folder, sound, report) {
        var path = "event:/" + sound.event_path.join("/");
        var assets = sound.files.map(function (file) {
            return assetOf(folder, sound, file, report);
        });
        var event = studio.project.lookup(path);
        if (!event) {
            create(sound, assets, report);
        } else if (event.isOfExactType("Event")) {
            update(event, path, assets, report);
        } else {
            report.different.push(path);
        }
    }

    function importPack() {
        var report = { folders: 0, assets: 0, events: 0, variations: 0, different: [], notReplaced: 0, failed: [] };
        var folder = projectFolder();
        readSounds(folder).forEach(function (sound) {
            try {
                importSound(folder, sound, report);
            } catch (error) {
                report.failed.push(sound.cue + ": " + error.message);
            }
        });
        return report;
    }

    function inWords(report) {
        var lines = [
            report.events + " events and " + report.folders + " folders made, " + report.assets +
                " files imported, " + report.variations + " variations added."
        ];
        if (report.different.length > 0) {
            lines.push("Left as they are, because they play other files: " + report.different.join(", "));
        }
        if (report.notReplaced > 0) {
            lines.push(
                report.notReplaced +
                    " files are in the project already. Where they changed, copy them over those in Assets."
            );
        }
        if (report.failed.length > 0) {
            lines.push("Not imported: " + report.failed.join("; "));
        }
        return lines.join("\n");
    }

    studio.menu.addMenuItem({
        name: "Soundlist\\Import pack",
        execute: function () {
            try {
                alert(inWords(importPack()));
            } catch (error) {
                alert("The pack was not imported. " + error.message);
            }
        }
    });
})();
