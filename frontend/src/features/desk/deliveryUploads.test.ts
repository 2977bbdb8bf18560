import { waitFor } from '@testing-library/react'
import { File as NodeFile } from 'node:buffer'

import { QueryClient } from '@tanstack/react-query'
import { expect, test } from 'vitest'

import { serve } from '@/test/server'
import { ANY_FILE } from '@/uploads'

import { DeliveryUploads } from './deliveryUploads'
import vectors from '@/precheck/vectors.json'

test('a renamed file is sent with the name that it had', async () => {
  const bytes = Uint8Array.from(atob(vectors[0]!.bytes), (one) => one.charCodeAt(0))
  const pick = (name: string, path: string) => ({
    file: new NodeFile([bytes], name) as unknown as File,
    path,
  })
  const { asked } = serve({
    'GET /v1/projects/p1/deliveries': { items: [{ id: 'd1', closed_at: null }], next: null },
    'POST /v1/deliveries/d1/files': { id: 't1', state: 'received' },
  })
  const uploads = new DeliveryUploads(new QueryClient(), 'p1', ANY_FILE)
  await uploads.add([pick('big laser.wav', 'laser.wav'), pick('step.wav', 'steps/step.wav')])
  const sent = () => asked.filter(({ path }) => path.endsWith('/files')).map(({ query }) => Object.fromEntries(query))
  await waitFor(() => expect(sent()).toHaveLength(2))
  expect(sent()).toEqual([{ file_name: 'laser.wav', received_name: 'big laser.wav' }, { file_name: 'steps/step.wav' }])
})
