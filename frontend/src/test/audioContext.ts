/** A Web Audio graph whose clock is turned by hand and which remembers what it was asked to sound. */

export interface Started {
  buffer: AudioBuffer
  atS: number
  fromS: number
  speed: number
  stoppedAtS: number | null
  loop: boolean
  loopStart: number
  loopEnd: number
  gain: { value: number; calls: [string, number, number][] }
  end: () => void
}

function bufferOf(durationS: number, samples: number[] = [1, 2, 3, 4]): AudioBuffer {
  const data = Float32Array.from(samples)
  return {
    duration: durationS,
    length: samples.length,
    numberOfChannels: 1,
    sampleRate: samples.length / durationS,
    getChannelData: () => data,
    copyToChannel: (source: Float32Array) => data.set(source),
    copyFromChannel: () => undefined,
  }
}

export class HandContext {
  currentTime = 0
  state = 'suspended'
  closed = false
  started: Started[] = []
  readonly destination = {}

  resume(): Promise<void> {
    this.state = 'running'
    return Promise.resolve()
  }

  close(): Promise<void> {
    this.closed = true
    return Promise.resolve()
  }

  decodeAudioData(data: ArrayBuffer): Promise<AudioBuffer> {
    const { durationS, samples } = JSON.parse(new TextDecoder().decode(data)) as {
      durationS: number
      samples?: number[]
    }
    return Promise.resolve(bufferOf(durationS, samples))
  }

  createBuffer(_channels: number, length: number, rate: number): AudioBuffer {
    return bufferOf(length / rate, Array<number>(length).fill(0))
  }

  createGain() {
    const calls: [string, number, number][] = []
    const gain = {
      value: 1,
      calls,
      setValueAtTime(value: number, atS: number) {
        calls.push(['set', value, atS])
        gain.value = value
      },
      linearRampToValueAtTime(value: number, atS: number) {
        calls.push(['ramp', value, atS])
        gain.value = value
      },
      cancelScheduledValues: () => undefined,
    }
    return { gain, connect: () => undefined, disconnect: () => undefined }
  }

  createBufferSource() {
    const started = this.started
    let connected: { gain: Started['gain'] } | null = null
    const node = {
      buffer: null as AudioBuffer | null,
      playbackRate: { value: 1 },
      loop: false,
      loopStart: 0,
      loopEnd: 0,
      onended: null as (() => void) | null,
      connect: (to: { gain: Started['gain'] }) => {
        connected = to
      },
      start(atS: number, fromS: number) {
        if (node.buffer === null || connected === null) throw new Error('started without a buffer or a gain')
        const record: Started = {
          buffer: node.buffer,
          atS,
          fromS,
          speed: node.playbackRate.value,
          stoppedAtS: null,
          gain: connected.gain,
          get loop() {
            return node.loop
          },
          get loopStart() {
            return node.loopStart
          },
          get loopEnd() {
            return node.loopEnd
          },
          end: () => node.onended?.(),
        }
        started.push(record)
        node.stop = (at: number) => {
          record.stoppedAtS = at
        }
      },
      stop: (at: number) => void at,
    }
    return node
  }
}
